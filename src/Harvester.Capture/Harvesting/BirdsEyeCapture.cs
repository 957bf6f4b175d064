using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Bird's-eye maps: the ground by the game's own geometry or by the known roads, vehicles and people by their boxes. docs/birds-eye.md
/// describes them.
/// </summary>
internal sealed class BirdsEyeCapture() : CaptureChannel(FrameChannels.BirdsEye)
{
    /// <inheritdoc />
    public override string? ProblemFor(HarvestOptions options, GamePorts game) =>
        !options.Freeze ? "Bird's-eye maps need a game that is frozen for each frame."
        : game.Ground is null && game.Roads is null ? "Bird's-eye maps need known roads. Survey them, or name a road file."
        : game.Ground is null && options.BirdsEye.ReachMetres > KnownGround.ReachMetres
            ? FormattableString.Invariant($"Bird's-eye maps of known roads reach {KnownGround.ReachMetres} m, and the corners of these ")
                + FormattableString.Invariant($"{options.BirdsEye.ReachMetres:0.0} m. Make them smaller.")
        : options.BirdsEyeProblem;

    /// <inheritdoc />
    public override IChannelLabeller LabellerFor(LabellingOptions options, FrameRays rays, GamePorts game) =>
        new BirdsEyeLabeller(options.BirdsEye, game.Ground ?? new KnownGround(game.Roads!, game.Paint), game.Surfaces);
}
