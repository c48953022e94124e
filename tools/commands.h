// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <CLI/App.hpp>

#include "tools/console.h"

/// One function a subcommand: adds it, with its options, below `parent`. The console must outlive
/// the parsing; the work is done by the subcommand's callback, which throws handcraft::Error.
/// Each lives in commands/<name>.cc.
namespace handcraft::tools {

void AddDataInfo(CLI::App& parent, const Console& console);
void AddDataCheck(CLI::App& parent, const Console& console);
void AddDataClouds(CLI::App& parent, const Console& console);
void AddDataExport(CLI::App& parent, const Console& console);
void AddDataImport(CLI::App& parent, const Console& console);
void AddDataPreview(CLI::App& parent, const Console& console);
void AddDataSplit(CLI::App& parent, const Console& console);
void AddDataSynth(CLI::App& parent, const Console& console);
void AddDataSynthDemonstrations(CLI::App& parent, const Console& console);
void AddDataSynthGraspPoints(CLI::App& parent, const Console& console);
void AddDataSynthMoved(CLI::App& parent, const Console& console);
void AddDataSynthRegrasp(CLI::App& parent, const Console& console);
void AddDataSynthTurntable(CLI::App& parent, const Console& console);
void AddTrainGraspLibrary(CLI::App& parent, const Console& console);
void AddTrainGraspPoints(CLI::App& parent, const Console& console);
void AddTrainLda(CLI::App& parent, const Console& console);
void AddTrainLogistic(CLI::App& parent, const Console& console);
void AddTrainObjectClass(CLI::App& parent, const Console& console);
void AddTrainSvm(CLI::App& parent, const Console& console);
void AddEvaluate(CLI::App& parent, const Console& console);
void AddPlan(CLI::App& parent, const Console& console);
void AddPlanGrasp(CLI::App& parent, const Console& console);
void AddPredict(CLI::App& parent, const Console& console);
void AddInspect(CLI::App& parent, const Console& console);
void AddCheckModel(CLI::App& parent, const Console& console);
void AddExport(CLI::App& parent, const Console& console);
void AddImport(CLI::App& parent, const Console& console);
void AddStudy(CLI::App& parent, const Console& console);
void AddStudyFeatureAnalysis(CLI::App& parent, const Console& console);
void AddBench(CLI::App& parent, const Console& console);
void AddRobot(CLI::App& parent, const Console& console);
void AddRobotFk(CLI::App& parent, const Console& console);
void AddRobotIk(CLI::App& parent, const Console& console);
void AddRobotInfo(CLI::App& parent, const Console& console);
void AddStudy(CLI::App& parent, const Console& console);
void AddStudyCompare(CLI::App& parent, const Console& console);
void AddStudyList(CLI::App& parent, const Console& console);
void AddStudyRun(CLI::App& parent, const Console& console);

}  // namespace handcraft::tools
