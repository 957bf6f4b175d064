using Harvester.Datasets.Logs;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>A scenario, and which of its steps are those of frames.</summary>
/// <param name="Log">The scenario.</param>
/// <param name="Measured">Whether a step is that of a frame; others are interpolated between two frames.</param>
internal sealed record AssembledScenario(MotionLog Log, IReadOnlyList<bool> Measured);
