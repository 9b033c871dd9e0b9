<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Directories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select All</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QPrintPreviewDialog</name>
    <message>
        <source>Print Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show single page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show facing pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show overview of all pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page setup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export to PDF</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Del</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Return</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select All</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>card</name>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Site</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Formation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preservation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Masonry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timber</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skeleton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Excavation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assessment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signatures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Short definition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Description</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interpretation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dug away on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Digging began on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dates and phases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Site code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Room or functional unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Formation (natural, artificial)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Criteria of distinction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode of formation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compaction or consistency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Munsell colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Composition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inclusions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Organic components</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inorganic components</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape in plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Break of slope, top and base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Borders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Truncation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Masonry: materials, size, finish</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Masonry: coursing and bond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Masonry: form and faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Masonry: bonding material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timber: type and setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timber: cross-section, conversion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timber: tool marks, joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skeleton: position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skeleton: completeness, truncation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Excavation method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Per cent excavated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sieving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reliability of the stratigraphy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Activity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dating evidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Observations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scientific director</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checked on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revised by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revised on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free fields (name=value lines)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind, more closely</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>changes</name>
    <message>
        <source>Accept a relation from surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept problem %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept registration run %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept relations from surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1 scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign %1 finds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct to %1, instead of %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard registration run %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw an outline of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find %1 scans again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a scan again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1 and %2 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1 markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1 outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import %1 outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make interpretation %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark %1 uncertain: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline changed ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline changed ground as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redraw region %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Register %1 scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reject a suggestion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reject suggestions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split unit %1, new %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take over %1 scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Withdraw %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>area %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dating %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>document %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>find %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>group %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interpretation %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>level %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>period %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phase %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>region %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relation %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scan %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept problem %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added %1 row of %2 with another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added %1 rows of %2 with another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed %1 row of %2 with another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed %1 rows of %2 with another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deleted %1 row of %2 with another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deleted %1 rows of %2 with another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import measured points of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restored %1 row of %2 with another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restored %1 rows of %2 with another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign the day off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept a problem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept problem “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept problem “%1” (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>evidence</name>
    <message>
        <source>upper one dug</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>area [m²]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lower one dug</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by years</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot tell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>difference [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>direct</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>earlier one not before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>later one not after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>close together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other unit [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to be removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the place [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the turn [°]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thickness [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tolerance [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>top [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>years</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>export</name>
    <message>
        <source>wrote %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not carried: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>log</name>
    <message>
        <source>recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deleted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brought back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another program</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>papers</name>
    <message>
        <source>no file is named</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not shown: it is not in the project&apos;s folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 may not be read by this user</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too large to be shown: %2 MB, up to %3 MB are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too large to be shown: %2 × %3 pixels, up to %4 million are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read as a picture: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no picture of a kind that can be shown here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::BackupRotation</name>
    <message>
        <source>Keeping a copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No copy of the project could be kept: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::BoxPanel</name>
    <message>
        <source>West to east</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>South to north</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut nothing away</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::CardPanel</name>
    <message>
        <source>Full record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a unit in the list, the matrix or a problem, or add a new one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of a new unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation: number, kind, number, Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new unit: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Levels, finds, papers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not saved yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::ContentsPanel</name>
    <message>
        <source>What is shown in 3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the time line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show what the time line stands on, and forget what was checked and cleared here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::DayJobs</name>
    <message>
        <source>%1: read as %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 new units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of them only mentioned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 units with fields filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 new relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 new statements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 new levels, finds, phases and others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: “%3” stands, the file says “%4”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not placed. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading what would be imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>imported: %1 new units, %2 new relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing in the files is new</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adding scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 scans added, %2 there already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking outlines in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 new outlines, %2 refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking measured points in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points: %2 new levels, %3 new finds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking markers in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 markers added, %2 as they were</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was changed: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Registering scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeping the places of the scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>backup written to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 scans placed on the site grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: placed with doubt. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::DifferenceBar</name>
    <message>
        <source>Compared with</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::DifferenceModel</name>
    <message>
        <source>There is no other surface of this area to compare with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comparing the surfaces …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lower than %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>higher than %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of %1 m² compared, %2 m² lower, %3 m² higher</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 saw no ground in common.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::DifferenceScale</name>
    <message>
        <source>%1 %2, grey within %3, %1 %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grey: closer than what can be told from none (95 %), %1 in the middle of all cells</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::FlatPage</name>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the whole (F)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::FlightCameras</name>
    <message>
        <source>Reading the cameras of the flight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>placing a camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forgetting the cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cameras stay in this window only: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeping the cameras of the flight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another window changed the cameras meanwhile; nothing was taken back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::FlightWriter</name>
    <message>
        <source>Writing %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (taken back)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::ImportDialog</name>
    <message>
        <source>what the files say replaces what differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is what would change; nothing is written yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing in the files is new.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Differs; the project&apos;s is kept unless you say otherwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not understood, or worth a look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The files cannot be read; nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::Inquiry</name>
    <message>
        <source>only in %1: %2 %3 %4; the other orders them the other way round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only in %1: %2 %3 %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>order of %1: %2 later than %3; the other says the opposite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>order of %1: %2 later than %3; the other does not order them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contradicted in %1 only: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 say the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: only in run %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: moves %2 mm, turns %3° (known within %4 and %5 mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neither run placed a scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 m², %3 m since the surface before; %4: %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all ground that changed is outlined</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n patch(es) outside all outlines left out</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Verifying the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no problem found in the file, its scans and their points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Registration %1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground not outlined yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outlines (*.geojson)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept registration %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard registration %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cleaning the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing was removed: the project file itself is not sound</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) removed, %1 MB</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>the project file is %1 MB shorter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrote %1: %2 points</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::JobSign</name>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopping …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::MainWindow</name>
    <message>
        <source>recorded: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New project …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open for reading only …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sunlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no project open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 units, %3 relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planum projects (*.gpkg);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planum projects (*.gpkg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 from the next start on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saving …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These fields could not be saved, and are lost when the project closes:
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the project open</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::MatrixCanvas</name>
    <message>
        <source>Drawing of the matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No drawing yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No units to draw. Import lists of units and relations, or add a unit in the record card.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::MatrixModel</name>
    <message>
        <source>Drawing the matrix</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::MatrixView</name>
    <message>
        <source>%1 boxes, %2 lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whole site</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>around the selected unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only what problems are about</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what changed since yesterday</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not folded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phases folded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>periods folded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>groups folded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Titles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Short definitions below the numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole drawing (F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>   – closes a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contradicted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not testable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which lines surfaces, sections and levels confirm or contradict</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::NoticeBar</name>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::OutlineBar</name>
    <message>
        <source>Draw an outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of the outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the outline encloses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the outline shows of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shows: by kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corner back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the last corner back (Backspace, Ctrl+Z); brings a cancelled outline back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the outline (Enter, or a click on the first corner)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc; can be taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change an outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves, sets and takes away corners of an outline that is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corner away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the chosen corner away (Delete, or the right button on it)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the last change of this outline back (Ctrl+Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the outline as it is now (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name what changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offers ground that changed since the surface before and has no outline yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes an outline of the patch, of the unit beside it (Enter)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::OutlineEdit</name>
    <message>
        <source>Change an outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the outline that shall be changed: click into it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This outline cannot be seen here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a corner, or the middle of a line for a new one; Delete takes a corner away.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::OutlineTool</name>
    <message>
        <source>Near it: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No unit %1 yet; it will be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw an outline</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::PanoramaCanvas</name>
    <message>
        <source>Panorama</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unrolling the scan …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No scan of this surface yet. Add scans from the project menu, or drop files on the window.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::PanoramaModel</name>
    <message>
        <source>Unrolling %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing was measured here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m from the scanner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x %1  y %2  height %3 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This scan is not on the site grid yet: register it, then outlines can be drawn.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::PanoramaView</name>
    <message>
        <source>Scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as scanned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reflectance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>equirectangular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cylindrical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mercator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Miller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>equal-area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rectilinear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pannini</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stereographic</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::PaperMenu</name>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On paper (*.pdf);;Picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report, plan, section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan to scale …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section to scale …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the whole record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report (*.pdf *.html *.xml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no surface to draw yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan to scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no section yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section to scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section between two points …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section between two points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From x y [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To x y [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A place is two numbers: x and y in metres.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::PatchModel</name>
    <message>
        <source>Looking for ground without outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name changed ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comparing with the surface before …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All ground that changed is outlined.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n patch(es) changed and have no outline: click into one.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 m², %2 m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::PhotoStrip</name>
    <message>
        <source>Photos and drawings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading photos</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::PhotoWindow</name>
    <message>
        <source>Previous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading the picture …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading photos</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::PlanCanvas</name>
    <message>
        <source>Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No outlines, finds or stations yet. Add scans, draw outlines on a panorama, or import outlines and measured points.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::PlanView</name>
    <message>
        <source>There is no surface to draw on yet.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::ProblemListModel</name>
    <message>
        <source>number %1 in “%2”, probably %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit %1, probably two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark uncertain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct the number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split the unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing contradicts anything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 relations state an order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 confirmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 contradicted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not testable: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep a problem silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign the day off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  · new</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n remark(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing the surfaces</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::ProblemPanel</name>
    <message>
        <source>Number of the new unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remarks too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sign the day off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What stands now is not new tomorrow; it is signed with your name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checking …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; signed off %1 by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1   (%2 %)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a problem: its proof shows in the matrix and in every other view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Known because …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to doubt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rests on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep it silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>; %n change(s) since</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Changed after the day was signed off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; the surfaces are still being compared</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::ProjectMenu</name>
    <message>
        <source>Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import lists …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists of units, relations, finds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add scans …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of a day&apos;s scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import outlines …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outlines (*.geojson *.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import measured points …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of the total station</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points (*.csv *.txt *.dxf);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export or print …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backup …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Planum projects (*.gpkg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a project first, then drop the files on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export or print</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matrix (*.pdf *.svg *.png);;Report (*.xml *.html);;For other programs (*.csv *.json *.lst *.hmcx *.graphml *.dot *.geojson *.ttl *.xlsx *.dxf *.oxcal)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>larger, smaller, the whole drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along the orders of the matrix, or move the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>while drawing: last corner back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>while drawing: cancel (can be taken back)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a sample dig …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print the matrix …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No matrix is drawn that could be printed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>small: 12 units, half a minute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>medium: 40 units, minutes, 600 MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a sample dig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New folder for the sample dig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making a sample dig</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::ProofPicture</name>
    <message>
        <source>Both faces in plan and cross-section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawing both faces …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing the proof</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to see it large</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::RecordsModel</name>
    <message>
        <source>Listing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::RecordsView</name>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find in the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of a new one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one of the list, or add one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::RelationEntryBar</name>
    <message>
        <source>Show the circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>covers, cut by, …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation: first unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation: kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation: second unit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::RelationEntryModel</name>
    <message>
        <source>Number of a unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation: covers, cut by, fills, …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the other unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is used in several areas; write AREA::%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no unit %1 yet; Enter adds it as one only mentioned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Near it: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That puts %1 above itself. Enter records it all the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That closes a circle: %1. Enter records it all the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add relation %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::ScansView</name>
    <message>
        <source>on the site grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not placed yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the original file is not where it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Register</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rms [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>within [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the scans on the site grid that are not there yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add scans …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markers …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of a day&apos;s scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Listing scans</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::SectionCanvas</name>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking along the section …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No section yet. Draw outlines or put scans on the site grid, and a cut through them shows here; a section of the record is a line between two surveyed points, which outlines name when they are imported.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::SectionLine</name>
    <message>
        <source>Too near the first one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where the line begins.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click where it ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m long</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::SectionLineBar</name>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look straight at it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show as a section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the section view, rectified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut nothing away (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::SectionModel</name>
    <message>
        <source>Cut, west to east</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut, south to north</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking along the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut, laid in 3D</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::SectionView</name>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m along, height %2 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cut to look at; outlines are drawn on recorded sections.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::SpaceCanvas</name>
    <message>
        <source>The 3D view needs OpenGL 3.3, which this display does not offer. All other views work.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.3; there is %1.%2 here. All other views work.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The site in 3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choosing points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking up a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The 3D view needs a display; the program runs without one (%1). All other views work.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::SpaceContents</name>
    <message>
        <source>Scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not on the site grid yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no heights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::SpaceModel</name>
    <message>
        <source>Opening the points</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::SpaceView</name>
    <message>
        <source>x %1  y %2  height %3 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m apart, %2 m up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour as scanned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shaded by depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan, north up (T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trench (F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) written</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut away what lies in front, above or behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place a camera here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the flight …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget the cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A flight along placed cameras, as numbered pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the flight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames from camera to camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces, scans and outlines on and off, one by one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>difference to another surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two clicks lay a line; what lies beside it is cut away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn, right button to move, wheel to come nearer; a click says the place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No point is there; come nearer, or click where points are drawn.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::StartPage</name>
    <message>
        <source>No project is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New project …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One file for the whole dig; lists, scans and outlines come into it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Or drop a project on the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a sample dig …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To try everything out: sheets, scans and a few mistakes to find.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opened lately</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::SuggestionListModel</name>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>accepted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asking the surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing proposed</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n relation(s) proposed</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n question(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2: which is later?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>area %1 m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thickness %1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sure to %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seen on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known to have touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accepting a suggestion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recorded from surfaces: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejecting a suggestion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot tell from the surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compiling a reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading %1: %2 relations from surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>planum::gui::SuggestionPanel</name>
    <message>
        <source>All as a reading …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decided ones too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All proposed relations as a reading of their own beside the record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asking the surfaces …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State the relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reject …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reject</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot tell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a suggestion: its units show in every view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Said nothing, or less than all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compile a reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the reading, beside the record</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::TimeLine</name>
    <message>
        <source>Surfaces in time</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::TimeModel</name>
    <message>
        <source>%1 scans, %2 outlines</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::TodayModel</name>
    <message>
        <source>Looking what is next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lacks %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::TodayPanel</name>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>May be dug next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheets that lack something</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::ToolsMenu</name>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare readings …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground not outlined yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare registrations …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept a registration …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accept a registration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard a registration …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard a registration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no reading beside the record to compare it with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no two registrations to compare.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare registrations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Registration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no registration yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as outlines …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrote %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify and clean up …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of a region …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify and clean up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept points, pictures and heights that nothing uses any more are removed. The record, the scans themselves and all that can be taken back stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clean up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no outline yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of a region</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Region</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points (*.ply)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::UnitCardModel</name>
    <message>
        <source>%1, line %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change unit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add unit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete unit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading what was changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”  %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: “%2” → “%3”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::UnitListModel</name>
    <message>
        <source>unit %1, %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(no sheet yet)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Short definition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Status</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::UnitPanel</name>
    <message>
        <source>with problems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a number or a word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kind not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all trenches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 units</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>planum::gui::Workspace</name>
    <message>
        <source>opened for reading only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this file may only be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was changed: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is gone. What you see was read before; put the file back, or save a copy elsewhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program changed the project; it was read again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the project again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another window has this project open, too. What either saves, the other shows at once.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>print</name>
    <message>
        <source>Print the matrix</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>reason</name>
    <message>
        <source>Reason, for those who read it in ten years</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>records</name>
    <message>
        <source>Trenches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Documents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Periods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Association</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Author</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box or bag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radiocarbon age [BP]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ of the age [years]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Category</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Description</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First unit number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From [year]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laboratory number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last unit number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rank (1 = earliest)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Role</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen in the side of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To [year]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume [l]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight [g]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name of the trench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>label of the date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of the document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of the find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of the group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name of the reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit that was levelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of the period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of the phase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface/unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of the sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>analysed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>terminus ante quem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>backfill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>baulk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>certain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charcoal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bare cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>discarded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>equipment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>level inside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dug by machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dug too deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>photo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in plana</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pollen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>terminus post quem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radiocarbon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soil</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spoil</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by stratigraphic units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>submitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>date of the unit itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uncertain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not excavated yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bottom of the cut</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>sentences</name>
    <message>
        <source>%1 covers %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cuts %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fills %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 abuts %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bonds with %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is the same as %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 borders %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is later than %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is contemporary with %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 steps more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 BCE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 CE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>terminus post quem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>terminus ante quem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>terminus post quem %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>terminus ante quem %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phase %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>period %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phase %1 of period %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (from %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (until %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 for %3?)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (two units under one number?)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 units lie above one another in a circle: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 units lie above one another in a circle once same-as is applied: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; nothing in the record tells which of these is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; most suspect: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, yet same-as makes the two one unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without it the two are two units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a unit cannot lie above itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in its favour: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every circle passes through %1, and no single relation breaks them all: probably two units under one number, to be split</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no circle is left when %1 and %2 are two units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without it some circles are gone, but not all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without it no circle is left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is one of %1 relations without which no circle is left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>doubting it instead would do as well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>doubting it instead would also break a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is probably meant instead of %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sheet of %1 states this relation with %2, whose own sheet names %3 instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, one slip of the pen away, lies nearer to %2 and would close no circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both sheets state it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only one of the two sheets states it, where most relations stand on both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only one of the two sheets states it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the upper unit was dug first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the lower unit was dug before the upper one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>numbers of this site grow downwards as a rule, here it is the other way round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the numbers follow each other as on the rest of the site</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the levels lie the other way round than between such units as a rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the levels lie as they should</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the two units lie far apart in plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the two units lie close together in plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the two numbers are further apart than those of units that touch as a rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the two numbers are close together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a cut or fill is hard to see the wrong way round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which of two deposits leans on the other is easily mistaken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leaning and age alone are weaker observations than covering</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is marked as uncertain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the kinds of the two units do not fit it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the levels of the two units exclude it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the levels of the two units confirm it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the dates of the two units exclude it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the dates of the two units agree with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the phases of the two units exclude it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the phases of the two units agree with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recorded surfaces show it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recorded surfaces show the opposite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another sheet, one slip of the pen away, states what this one seems to mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a correlation across a gap, not one unit seen twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the two units lie in different areas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the two units are of different kinds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the dates of the two units exclude each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: a unit cannot lie above itself; probably another number was meant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, and %2: one of the two is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, yet %2 puts one after the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: one contact stated as two kinds; the order is the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is written twice on one sheet (lines %2 and %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 follows from other relations; it is kept as evidence and left out of the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 relations follow from others; they are kept as evidence and left out of the drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: its base at %2 lies %3 above its top at %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, measured at the same place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but the %2 of %3 (%4) is %5 higher than the %6 of %7 (%8)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but the %2 of %3 (%4) is %5 lower than the %6 of %7 (%8)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>highest level on top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lowest level at the base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deepest level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>find %1 is recorded in %2, which is a cut and can hold nothing; it belongs to a fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>find %1 at %2 lies %3 above the top of %4 (%5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>find %1 at %2 lies %3 below the base of %4 (%5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but in the section %2 lies on %3 along %4 m: the relation is the wrong way round, or an outline carries the wrong number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but over %2 m² %3 lay above %4, which came out %5 m lower: the relation is the wrong way round, or an outline carries the wrong number, or %6 was dug before %7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>levels do not decide it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>levels agree, which proves nothing for a cut or a fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no levels of one of the units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no levels of either unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>abutting says nothing about heights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stated in time only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the levels of one unit contradict themselves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the find may be intrusive, or the relation wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sample may be intrusive, or the relation wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of the dates or the relation is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but %2 is not later than %3 (%4) and %5 not earlier than %6 (%7): %8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds dates that exclude each other: not earlier than %2 (%3), not later than %4 (%5); %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but %2 belongs to %3 and %4 to %5, which is later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but %2 was dug out on %3, before %4 was dug on %5: the relation, a date or the sequence of digging is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is recorded as %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is recorded as %2 and %3 as %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; only a cut or a feature cuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; a cut fills nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; only cuts, features and structures are filled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; only what was built bonds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; a cut has no body that could lie or lean on anything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deposit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>structure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>natural</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>void</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a fill, but no cut is named that it fills</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a cut, but nothing is recorded that fills it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a cut, but nothing is recorded that it cuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but %2 is natural ground; nothing made by people lies below it unless it was moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number %1 is given to %2 units (%3), though numbers are unique on this site</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stands in area %2, whose numbers run from %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 of %3 relations stand on one of the two sheets only, among them: %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is named in a relation (%2) but has no sheet of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the %2 of %3 is %4 here and was %5 before; the first is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stands in no order to any other unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 units stand in no order to any other unit, among them %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 scans are placed poorly, among them %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 units are named in relations but have no sheet of their own, among them %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stands where it does only to %2 mm and %3 degrees: %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run says no more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 patches of ground on which scans of one surface disagree, among them %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but over %2 m² the bare cut %3 came out where %4 had been, %5 m lower: %6, or %7 cuts %8 from beside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 patches of ground rose, among them %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ground without a unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on %1 scans disagree over %2 m² of %3 near %4 at %5 to %6 m: %7 shows it %8 m higher than %9; it changed between the two, or one of them is misplaced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on %1 %2 m² of %3 near %4 at %5 to %6 m lay %7 m higher than on %8: heaped up, filled in, or a scan is misplaced; nothing is concluded there until it is below its former height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on %1 %2 of %3 lay bare where %4 had been on %5, %6 lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on %1 %2 of the cut %3 lay bare where %4 had been on %5, %6 lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cut %1 was empty on %2; on %3 %4 of %5 lay %6 below its bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on %1 %2 of %3 lay bare where %4 had been on %5, too little lower for the heights to tell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from %1 to %2 the line between %3 and %4 moved into %5 over %6 while the ground went down %7: %8 dips flat under %9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where %1 was on %2, %3 of %4 came out on %5, %6 lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lies inside %2 and became smaller by %3 from %4 to %5, %6 lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on %1 %2 of the natural ground %3 lay bare where %4 had been on %5, %6 lower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 first showed on %2, in %3 where %4 had been on %5: was it covered by %6, or was it there already and seen too late? Look at the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 grew into %2 by %3 from %4 to %5: is it covered by %6, or undercut into it? Look at the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on %1 %2 of %3 came out where %4 had been on %5, and one of the two is built: which was there first?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on %1 %2 of the cut %3 lay below where %4 had been on %5: did %6 lie in or over it, or was it the roof of a hollow that reaches under it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on %1 %2 of %3 lay where %4 had been on %5, but only along the outlines: did they touch there?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; the record puts %2 above %3: one of the two is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 January %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 February %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 March %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 April %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 May %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 June %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 July %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 August %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 September %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 October %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 November %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 December %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the ground came up by %1 m: spoil, backfill, a slump or something put down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no unit was outlined here before, so the record says nothing of what lies below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is outlined beside it and goes on without a step along %2 % of its edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was dug away here, and %2 is the only unit recorded below it that goes on beside it without a step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was dug away here, and %2 is the only unit recorded below it that was not outlined yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was dug away here, and %2 is the only unit recorded below it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was dug away here; the record has no unit below it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was dug away here; recorded below it are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 scans are not on the site grid, among them %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not on the site grid, so nothing can be concluded from it; Register in the list of scans says why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; the record has %2 above %3 and %4 above %5: one of the two is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the outline of %1 on %2 near %3 %4 reaches %5 away from all set-ups of the scanner: plans leave it out and nothing is concluded from it; is it in other coordinates than the site?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 both claim %3 m² near %4 %5: neither gets that ground, and nothing is concluded from it until one of the outlines is redrawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface %1 of %2 stands before %3 of %4 in the order of surfaces, though its day is later: nothing is concluded from either until they are put in their order (Finds and lists › Surfaces › Place in time)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: one of %2 relations stands on one of the two sheets only: %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>services</name>
    <message>
        <source>no such file; Project › New project makes one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a Planum project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no area %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no scan %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no surface %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no region %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no field %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 exists already; choose it in the list to change it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an outline is drawn: on the panorama, in plan or on a section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a problem is kept silent with a reason only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this problem is not open any more; the list was checked again meanwhile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this problem is not in the list any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this suggestion is not open any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a question; state the relation that you saw, or reject it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a suggestion is rejected with a reason only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is a reading %1 already; choose another name, or delete it in Finds and lists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of which day? Put it into a folder named by its date (2025-06-01) and add that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project has another scan %1 with other content; rename the file or put it into the folder of another day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scan %1 has no %2; range and shading can always be drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scan %1: %2 is no longer the file that was added; put that back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no longer the file that was added; put that back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>block %1 with %2 points is damaged; Tools › Verify the project makes it again from the original scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is LAZ, compressed LAS, which is not read here; unpack it to LAS first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marker %1 of %2 is %3 mm from where the file has it; it was kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project&apos;s markers cannot be read: take the change back that spoilt them (Edit › Undo)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project has no scans yet: Add scans takes the folder of a day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every scan is on the site grid already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing says where the site grid is: import the markers of one scan at least (Markers)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no registration yet: Register places the scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the registration %2 is not in force: %1; Tools › Accept a registration puts it in force, Discard a registration drops it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface %1: none of its scans stands on the site grid; Register in the list of scans places them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project has no surface yet; scans or outlines of a day make them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neither outlines nor registered scans say where the trench is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it names neither a surface nor a day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no scan is on the site grid: register the scans first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no scan of this surface is on the site grid: register its scans first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not recognised: none of the lists that Planum reads (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read as %1 (%2)%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out: too large for a list; scans are added with Add scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number %1 is used in area %2 and in area %3 and was taken for one unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>site %1 with %2 units was read; left out: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none of its rows holds coordinates; its first line must name the columns (name, x, y, z, code, …)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 trenches have a unit %2; the file must say which (TRENCH::NUMBER)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no such file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no such file or folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not an ordinary file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>empty; a marker file begins with scan,marker,x,y,z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a database, but not a GeoPackage and so not a Planum project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a GeoPackage, but not a Planum project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>made with schema version %1, this program knows up to %2: install a newer Planum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the table %1 is missing: not a whole Planum project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the table %1 has no column %2: another program rebuilt it; restore a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the table %1 was rebuilt by another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project has no schema version</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project has no settings: restore a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is damaged (%1): restore a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is damaged: restore a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is damaged or cut short: restore a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is cut short: restore a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is cut short (%1 of %2 bytes): restore a backup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file or its folder is read-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file or its folder cannot be written: check the permissions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the disk is full: nothing was changed; free some space and try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in use by another program: close it there and try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an interrupted change has to be taken back first, and the file or its folder cannot be written: copy it with the files beside it to a place that can</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be opened: check the name, the folder and the permissions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be opened: check the permissions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be opened for reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>access denied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a value is larger than 64 MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another program changed the tables meanwhile: try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the record of this change is damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the record of this change is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the record of this change names a table it may not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of a project must end in .gpkg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a file of this name is there already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opened for reading only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>may be read but not written, because %1: import it into a new project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 %2 was not made by Planum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the index %1 was not made by Planum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a change that had been interrupted was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another program left the file in write-ahead mode (is it open in QGIS?)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file had been left in write-ahead mode; it was set back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file stays in write-ahead mode while another program uses it (is it open in QGIS?)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brought from schema version %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the spatial index of the layer %1 was dropped: its triggers cannot run safely; QGIS works without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 had been dropped by another program; it was put back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows of the table %1 that were added since refer to the %2 it would take away: delete them first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was changed since by another program; nothing was done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; of %3 is no longer possible: undo steps up to then were forgotten</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is nothing to take back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is nothing to make again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number already used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number already used in area %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it refers to a record that does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a value is not allowed (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must not be empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a record with this id is there already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of this name is there already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no field of a unit is called %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no coordinate system EPSG:%1 is known; use -1 for a local grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no EPSG code; use -1 for a local grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 MB, more than the %2 MB that such a file may have</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is a project or another database; name another file to write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a backup must be another file than the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be opened to be written to the disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing to the disk failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the copy is damaged: check the disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading failed half-way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing to disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File exists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is between units of which one was deleted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>belongs to a relation that was deleted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>belongs to a unit that was deleted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is a number that several units have</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drops a relation that does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is listed but does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refers to a %1 that does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has no valid uuid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be taken back: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no file to import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>could also be read as %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out: no record that Planum knows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 relations stand on both sheets, the rest on one; the other side is derived</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing in it but headings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the project stay behind: only its record is imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables of units, relations, levels, finds, … (.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole record (.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Harris Matrix Composer project (.hmcx, matrix.xml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Harris Matrix Composer table (.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ArkMatrix table, simple or tagged (.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>BASP, ArchEd, Stratify dataset (.lst)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GraphML of yEd or the Extended Matrix (.graphml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>iDAI.field / Field Desktop export (.jsonl)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hm and HMDP tables (contexts, observations, …)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transcription of excavation books (book, feature, relations)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PHASER tables (.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PHASER graph (.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PolyChron tables (.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stratify table (.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>StratiGraph matrix (.hmatrix.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stratigraphr table (context, above, below, equal)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pyArchInit database or CSV tables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns unit, kind, title, … or unit, relation, other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two columns of numbers without a header</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows of unit, value, tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns above, below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; the line was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2 here and was %3 before; the first is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the title of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the description of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the interpretation of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the label of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the phase of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the period of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first day of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last day of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recorder of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the recording day of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 names no other unit; the relation was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 further notes are not listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than two cells; only two were read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not three cells: unit, value, tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line without a unit was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line without a unit number was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line without a group was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a unit without a number was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a level without a height z was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tag %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the class %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the class %1 is not known; taken as context</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the status %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the status %1 is not known; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the kind %1 is not known; kept as a free field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the form %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the role %1 is not known; taken as other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the method %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the kind of dating %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the key %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the type %1 of %2 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the unit type %1 of %2 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the edge type %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the relation %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no relation word known here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field %1 is not known; kept among the free fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the column %1 is not known; kept among the free fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the column %1 is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>certainty is certain or uncertain, not %1; taken as certain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a level needs a unit and a height z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a number in the column %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a whole number in the column %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a date in the column %2 (2025-06-01)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no table of ours; looked in the first line for the columns %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 characters are no text in %2 and were replaced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the table has more than %1 cells; what follows was not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a quotation mark is opened and never closed; taken as a character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a node without label; named by its id, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two nodes are called %1; they are taken for one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an edge ends at a node that is not in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an edge of a group was left out; only units have relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a relation of a group was left out; only units have relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a relation of a group of units was left out; only units have relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a row without number of a unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than %1 units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than %1 relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>binary, not %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit %1: %2 is no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds no points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns %1: there is no x and y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no coordinates; the row was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a binary drawing; save it as ASCII DXF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds no POINT, INSERT or TEXT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a level without a height was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from here on, %1 levels without a height were left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no unit %2; near it: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no unit %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a level without a unit was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a find without a number was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>building the matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking for circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comparing relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comparing levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comparing dates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comparing phases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>following the digging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking at kinds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking at numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking at sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking at scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking at outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking at ground that changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>counting redundant relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checking pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checking references</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checking rules</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checking changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checking %1 scans and their points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading the record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copying the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking for features</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thinning %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing the PDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking into %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking at what %1 shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>making the point store of %1 again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unrolling %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawing the matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cleaning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comparing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comparing surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>merging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>importing the sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taking the outlines in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawing and reporting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>letting a site come to be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking at what touches what</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>digging it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawing and writing sheets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scanning %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking for ground that changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fine alignment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relaxing all poses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>global relaxation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sorting the points of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading points into cells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>making the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aligning %1 pairs of scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>registering %1 scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>adding %1 scan files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>laying the matrix out with graphviz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dating</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interpretation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>region</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relation below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no day; write YYYY-MM-DD</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is none of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no %1; add it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no area %1; add it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no dating %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no document %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no find %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no group %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no interpretation %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no level %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no period %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no phase %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no relation %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no sample %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no unit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no unit %1; near it: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a %1 needs a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a unit needs a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a level needs a height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit %1 is used in %2 areas; say which: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a relation is UNIT RELATION UNIT, as in 1042 cuts 1017, not %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no relation; known are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing in the record is called %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a correction needs a reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that is the relation as it stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the relation is not in the record any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the unit is not in the record any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the new unit needs a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no kind of unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no relation %1 %2 %3 in what the interpretation is of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no interpretation %1; add it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is read from %2 itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interpretation %1: %2 starts from it; give that another parent or delete it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>metres, not below 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read “%1”; write x y z, x y z, … or POLYGON((…))</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name a new region SURFACE/UNIT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the region is no longer there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its outline was changed meanwhile; nothing was done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outline mended: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scans and outlines do not show this contradiction any more; check again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no section shows this contradiction any more; check again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the surfaces propose nothing; outlines on two surfaces of an area with registered scans are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name in full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first year, negative = BCE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last year, negative = BCE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>order in time, 1 = earliest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>group, subgroup, landuse, activity, …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>group it is part of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its units, separated by commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit it dates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kind of evidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>earliest year, negative = BCE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>latest year, negative = BCE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uncalibrated radiocarbon age [years BP]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its sigma [years]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>find it rests on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>direct, disjunct, disparate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the interpretation it starts from (default: the field record)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relations it adds, as in &quot;1 covers 2; 3 cuts 4&quot;; set adds to those there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relations it leaves out; set adds to those there; &quot;adds&quot; brings one back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>who reads it so (default: you)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit it was found in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>site grid [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>height [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how many</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weight [g]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>condition</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>box or bag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>day it was found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>description</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit it was taken from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soil, C14, charcoal, pollen, …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>volume [l]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number the laboratory gave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stored, submitted, analysed, discarded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit it shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>photo, drawing, sheet, …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>file, relative to the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>day it was made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>author</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the height stands for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how it is dug</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first unit number issued to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last unit number issued to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how it was made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place in time among the surfaces of its area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit it shows; empty: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what it encloses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what of the unit it shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>corners in site coordinates: &quot;x y z, x y z, …&quot; or without heights, or WKT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uncertainty of the outline [m]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut whose side shows it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no scan file there (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not the ending of a scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has no scan in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project has another scan %1 with other content</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>has no valid point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points over 131 km away were left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns read as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the day is the one written in the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface %1 exists in several areas; say which area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2: not a day of the calendar as 2025-06-01</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scan %1: the original %2 is not there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scan %1 has no points: there is nothing to unroll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reflectance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scan %1: its points are not in %2 and the original %3 is not there either; put it back or add the scan again from where it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its original is not there: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>put it back, its points could not be made again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 blocks of its point store are damaged, the first at byte %3 with %4 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its point store is damaged: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>made again from the original</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it could not be made again: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no column %1; a marker file begins with scan,marker,x,y,z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing under %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a marker without a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no %2 coordinate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing under scan; rows of the survey say site there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the marker %1 of %2 a second time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the project has no scan %1 (yet)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marker %1 of %2 was not surveyed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no scan was made on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>placed by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>poorly placed by %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its own frame, which is taken for the site grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 markers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 links</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 markers and 1 link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 markers and %2 links</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its position is only known to %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its direction is only known to %1 degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was placed by features alone, which are good to centimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marker %1 left out: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 left out: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its markers were left out: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relaxation took the links&apos; errors from %1 to %2 standard deviations (root mean square); of %3 links %4 gave way to others, none is off by more than %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not placed: the scan has no points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not placed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its markers: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no markers were measured in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it hangs together with %1, but nothing says where these are on the site grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no start value near that of another scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it shares too little with the other scans: at best %1 places look alike and lie the same way to each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the report of a registration run cannot be read; discard the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no registration run %1; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>registration run %1 is accepted already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>registration run %1 is discarded already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing was placed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>proposed only, as asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 scans are placed poorly (%3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scan %1 was removed while it was registered; nothing was kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aligned on %1 of %2 pieces of ground, %3 mm rms, σ %4 mm and %5°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in the survey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surveyed %1 times: keep one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured more than once in this scan: keep one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the markers lie almost on one line, which leaves the turn about it open: add one beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the three markers do not fit the survey, distances differ by up to %1, and with three nobody can say which is wrong: measure a fourth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no three of the %1 markers fit the survey, distances differ by up to %2: is it the survey of this site?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the markers %1 and the markers %2 say different poses and neither set is larger: measure them again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm off its place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swapped with %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lies where %1 was surveyed: wrong name?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 markers fit with %3 mm rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the scan&apos;s %2 markers can be paired with the survey, three are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contradicts the other links and markers by %1 standard deviations (%2 mm, %3 degrees)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the surface is no longer in the record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surfaces %1 and %2 belong to two areas; only those of one can be compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: there are neither outlines nor registered scans to show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit %1 has no outline on any surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no registered scan shows it; the plan has outlines only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not registered and was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both ends of the section are one place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neither registered scans nor outlines lie in this plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no registered scan of %1 shows region %2; add scans of that day and register them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>region %1 lies outside all scans of its day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has several parts; say which: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface %1 is not of area %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface %1 is new and has no day</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section %1 is new: say its two ends, from and to [x, y]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit %1 may be %2; say which, or the area of the outlines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: no registered surface before it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no GeoJSON: its type is none of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds no outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its coordinates are degrees (%1); export it in the coordinate system of the site grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 outlined units in one area; %2 can be compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>periods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no problem to draw: no error or warning names a relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing was added, removed or changed since %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no format ends in %1; known are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plans and sections are written as .pdf or .png</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a report is .xml, .html or .pdf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>day %1: nothing was dug, recorded or scanned on it; %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the record holds no dates at all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last day before it with something is %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first day with something is %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not empty; name a new folder for the sample dig, or remove this one if a stopped run left it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the site has no %1 yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface %1: no scan of its days is in the project; Add scans brings them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its days and its place in the order of surfaces disagree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an outline is left out, more than %1 m from all scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 outlines are left out, more than %2 m from all scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none of its scans stands on the site grid; Register in the list of scans places them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no scan of its days is in the project; Add scans brings them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lies more than %2 m from all scans and was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it reaches %1 away from all set-ups of the scanner: plans leave it out and nothing is concluded from it; is it in other coordinates than the site?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it overlaps %1 by %2 m²; neither gets that ground</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it lies %1 m off the plane of section %2, which runs from %3 %4 to %5 %6; outlines on a section lie within %7 m of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ends on %2, before it begins on %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface %1 stands before %2, though its day is later: nothing is concluded from either until their places in time or their days are put right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1 is not UTF-8: save the file as UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not valid JSON at line %1, column %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1, column %2: JSON has no number %3; leave it out or write null</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line %1, column %2: the number %3 is too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading or writing the disk failed (%1): nothing was changed; see that the disk has space, is still there and allows files of this size, and try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is a list and not one word or number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is an object and not one word or number</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>views</name>
    <message>
        <source>Units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panorama</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds and lists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record card</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Today</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>words</name>
    <message>
        <source>layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>masonry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>timber</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>burial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deposit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>structure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>interface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>natural</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>void number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>partly excavated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>excavated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not excavated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>void</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>covered by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>covers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>filled by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fills</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>abutted by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>abuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bonds with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>same as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>borders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>earlier than</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>later than</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contemporary with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bottom of the cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spoil</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>backfill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>equipment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>baulk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not excavated yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shows: its top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shows: a level inside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shows: the bare cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shows: dug too deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shows: dug by machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shows: a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shows: nothing of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units above one another in a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle made by “same as”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit above itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stated both ways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contemporary, yet ordered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces contradict the relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Levels contradict the relation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dates contradict the order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phases contradict the order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dug before what lay above it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find outside its unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation does not fit the kinds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill without a cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut without a fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut that cuts nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something lies below the natural</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number used twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number outside its block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation stated twice on one sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stated on one sheet only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit without a sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not understood on import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit without relations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit without an outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline without a unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scan not on the site grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scan placed with doubt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface changed while it was scanned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground rose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relation that others imply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surfaces in the wrong order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline far from all scans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outlines on the same ground</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
