using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>Options that exclude each other, or that a game does not allow.</summary>
internal static class HarvestConflicts
{
    /// <summary>Why a harvest cannot have these options; null if it can.</summary>
    public static string? Of(HarvestOptions options, GamePorts game) =>
        options switch
        {
            { Freeze: false, Masks: true } => "Masks need a game that is frozen for each frame.",
            { MaskMethod: MaskMethod.Both, Shard.Count: > 1 } or { MaskMethod: MaskMethod.Both, RecordedThrough: >= 0 } =>
                "Masks of two methods are compared in whole harvests only.",
            { Freeze: false, Shard.Count: > 1 } or { Freeze: false, RecordedThrough: >= 0 } =>
                "Skipping frames needs a game that is frozen for each frame.",
            { Rig: not null } when !options.Freeze || options.MaskMethod != MaskMethod.Rays || game.RigCamera is null =>
                "A rig needs a game that is frozen for each moment and lets its camera move, and masks from rays.",
            _ => options.KeepProblem ?? CaptureChannels.ProblemFor(options, game),
        };
}
