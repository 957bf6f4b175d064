using Harvester.Capture.Ports;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>Further pictures of moments, which <see cref="PairPhotographer"/> takes.</summary>
internal sealed class PairCapture() : CaptureChannel(FrameChannels.Pairs)
{
    /// <inheritdoc />
    public override bool IsOn(HarvestOptions options) => options.Pairs.IsAny;

    /// <inheritdoc />
    public override string? ProblemFor(HarvestOptions options, GamePorts game) =>
        options is { Freeze: true, Rig: null } && game is { Sky: not null, Visibility: not null }
            ? null
            : "Pairs need a game that is frozen for each moment, without a rig, and lets its weather be set and its objects be hidden.";

    /// <inheritdoc />
    public override IEnumerable<string> FoldersFor(HarvestOptions options) => [FramePaths.Pairs];
}
