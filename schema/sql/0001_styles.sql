-- How QGIS draws the layers; deleted rows are not drawn. The table's columns are QGIS's own.
CREATE TABLE layer_styles (
  id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL,
  f_table_catalog TEXT(256),
  f_table_schema TEXT(256),
  f_table_name TEXT(256),
  f_geometry_column TEXT(256),
  styleName TEXT(30),
  styleQML TEXT,
  styleSLD TEXT,
  useAsDefault BOOLEAN,
  description TEXT,
  owner TEXT(30),
  ui TEXT(30),
  update_time DATETIME DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now'))
);
INSERT INTO layer_styles(f_table_catalog, f_table_schema, f_table_name, f_geometry_column, styleName, styleQML,
                         styleSLD, useAsDefault, description, owner) VALUES
('', '', 'region', 'geom', 'Planum', '<!DOCTYPE qgis PUBLIC "http://mrcc.com/qgis.dtd" "SYSTEM">
<qgis version="3.22" styleCategories="Symbology|Labeling">
 <renderer-v2 type="RuleRenderer" forceraster="0" symbollevels="0">
  <rules key="planum">
   <rule key="unit" symbol="0" label="Units" filter="&quot;deleted_at&quot; IS NULL AND &quot;category&quot; = ''unit'' AND &quot;shows&quot; &lt;&gt; ''cut''"/>
   <rule key="cut" symbol="1" label="Bare cuts" filter="&quot;deleted_at&quot; IS NULL AND &quot;category&quot; = ''unit'' AND &quot;shows&quot; = ''cut''"/>
   <rule key="other" symbol="2" label="No units" filter="&quot;deleted_at&quot; IS NULL AND &quot;category&quot; &lt;&gt; ''unit''"/>
  </rules>
  <symbols>
   <symbol name="0" type="fill" alpha="0.7"><layer class="SimpleFill" enabled="1" locked="0" pass="0">
    <prop k="color" v="230,200,140,255"/><prop k="outline_color" v="60,45,20,255"/><prop k="outline_width" v="0.3"/><prop k="style" v="solid"/></layer></symbol>
   <symbol name="1" type="fill" alpha="0.7"><layer class="SimpleFill" enabled="1" locked="0" pass="0">
    <prop k="color" v="255,255,255,255"/><prop k="outline_color" v="170,40,30,255"/><prop k="outline_width" v="0.5"/><prop k="style" v="b_diagonal"/></layer></symbol>
   <symbol name="2" type="fill" alpha="0.5"><layer class="SimpleFill" enabled="1" locked="0" pass="0">
    <prop k="color" v="190,190,190,255"/><prop k="outline_color" v="120,120,120,255"/><prop k="outline_style" v="dash"/><prop k="style" v="solid"/></layer></symbol>
  </symbols>
 </renderer-v2>
 <labeling type="simple"><settings><text-style isExpression="1" fieldName="coalesce(attribute(get_feature(''unit'',''uuid'',&quot;unit&quot;),''number''), &quot;unit_as_drawn&quot;, &quot;category&quot;)" fontSize="9" textColor="40,30,10,255"/><placement placement="1"/></settings></labeling>
</qgis>', '', 1, 'Outlines by what they show', ''),
('', '', 'find', 'geom', 'Planum', '<!DOCTYPE qgis PUBLIC "http://mrcc.com/qgis.dtd" "SYSTEM">
<qgis version="3.22" styleCategories="Symbology|Labeling">
 <renderer-v2 type="RuleRenderer" forceraster="0" symbollevels="0">
  <rules key="planum"><rule key="find" symbol="0" label="Finds" filter="&quot;deleted_at&quot; IS NULL"/></rules>
  <symbols>
   <symbol name="0" type="marker" alpha="1"><layer class="SimpleMarker" enabled="1" locked="0" pass="0">
    <prop k="name" v="diamond"/><prop k="color" v="200,60,30,255"/><prop k="outline_color" v="60,20,10,255"/><prop k="size" v="2.6"/></layer></symbol>
  </symbols>
 </renderer-v2>
 <labeling type="simple"><settings><text-style fieldName="number" fontSize="8" textColor="120,30,10,255"/></settings></labeling>
</qgis>', '', 1, 'Finds with their numbers', ''),
('', '', 'level', 'geom', 'Planum', '<!DOCTYPE qgis PUBLIC "http://mrcc.com/qgis.dtd" "SYSTEM">
<qgis version="3.22" styleCategories="Symbology|Labeling">
 <renderer-v2 type="RuleRenderer" forceraster="0" symbollevels="0">
  <rules key="planum"><rule key="level" symbol="0" label="Levels" filter="&quot;deleted_at&quot; IS NULL"/></rules>
  <symbols>
   <symbol name="0" type="marker" alpha="1"><layer class="SimpleMarker" enabled="1" locked="0" pass="0">
    <prop k="name" v="cross"/><prop k="color" v="20,60,150,255"/><prop k="outline_color" v="20,60,150,255"/><prop k="size" v="2.2"/></layer></symbol>
  </symbols>
 </renderer-v2>
 <labeling type="simple"><settings><text-style isExpression="1" fieldName="format_number(&quot;z&quot;, 2)" fontSize="8" textColor="20,60,150,255"/></settings></labeling>
</qgis>', '', 1, 'Levels with their heights in metres', ''),
('', '', 'section', 'geom', 'Planum', '<!DOCTYPE qgis PUBLIC "http://mrcc.com/qgis.dtd" "SYSTEM">
<qgis version="3.22" styleCategories="Symbology|Labeling">
 <renderer-v2 type="RuleRenderer" forceraster="0" symbollevels="0">
  <rules key="planum"><rule key="section" symbol="0" label="Sections" filter="&quot;deleted_at&quot; IS NULL"/></rules>
  <symbols>
   <symbol name="0" type="line" alpha="1"><layer class="SimpleLine" enabled="1" locked="0" pass="0">
    <prop k="line_color" v="30,30,30,255"/><prop k="line_width" v="0.5"/><prop k="line_style" v="dash dot"/></layer></symbol>
  </symbols>
 </renderer-v2>
 <labeling type="simple"><settings><text-style fieldName="name" fontSize="9" textColor="30,30,30,255"/></settings></labeling>
</qgis>', '', 1, 'Lines of the sections', ''),
('', '', 'scan_pose', 'geom', 'Planum', '<!DOCTYPE qgis PUBLIC "http://mrcc.com/qgis.dtd" "SYSTEM">
<qgis version="3.22" styleCategories="Symbology|Labeling">
 <renderer-v2 type="RuleRenderer" forceraster="0" symbollevels="0">
  <rules key="planum"><rule key="station" symbol="0" label="Scan stations" filter="&quot;deleted_at&quot; IS NULL"/></rules>
  <symbols>
   <symbol name="0" type="marker" alpha="1"><layer class="SimpleMarker" enabled="1" locked="0" pass="0">
    <prop k="name" v="triangle"/><prop k="color" v="20,120,60,255"/><prop k="outline_color" v="10,60,30,255"/><prop k="size" v="3"/></layer></symbol>
  </symbols>
 </renderer-v2>
 <labeling type="simple"><settings><text-style isExpression="1" fieldName="attribute(get_feature(''scan'',''uuid'',&quot;scan&quot;),''name'')" fontSize="8" textColor="20,120,60,255"/></settings></labeling>
</qgis>', '', 1, 'Where the scanner stood', '');
