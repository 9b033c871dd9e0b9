// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/uuid.hpp"

namespace planum::model {

using AreaId = Id<struct AreaTag>;
using UnitId = Id<struct UnitTag>;
using RelationId = Id<struct RelationTag>;
using StatementId = Id<struct StatementTag>;
using SourceId = Id<struct SourceTag>;
using ImportNoteId = Id<struct ImportNoteTag>;
using PeriodId = Id<struct PeriodTag>;
using PhaseId = Id<struct PhaseTag>;
using GroupId = Id<struct GroupTag>;
using DatingId = Id<struct DatingTag>;
using LevelId = Id<struct LevelTag>;
using FindId = Id<struct FindTag>;
using SampleId = Id<struct SampleTag>;
using DocumentId = Id<struct DocumentTag>;
using SurfaceId = Id<struct SurfaceTag>;
using SectionId = Id<struct SectionTag>;
using RegionId = Id<struct RegionTag>;
using ScanId = Id<struct ScanTag>;
using RegistrationRunId = Id<struct RegistrationRunTag>;
using DecisionId = Id<struct DecisionTag>;
using InterpretationId = Id<struct InterpretationTag>;

} // namespace planum::model
