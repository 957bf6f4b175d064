using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Harvesting;

/// <summary>Voxels around the vehicle, from the surfaces of a simulated game. docs/occupancy.md describes them.</summary>
internal sealed class OccupancyCapture() : CaptureChannel(FrameChannels.Occupancy)
{
    /// <inheritdoc />
    public override string? ProblemFor(HarvestOptions options, GamePorts game) =>
        game.Solids is null || game.Surfaces is null
            ? "Voxels need the simulated game: GTA V gives no surfaces that are out of sight. Turn Occupancy off."
        : !options.Freeze ? "Voxels need a game that is frozen for each frame."
        : options.OccupancyProblem;

    /// <inheritdoc />
    public override IChannelLabeller LabellerFor(LabellingOptions options, FrameRays rays, GamePorts game) =>
        new OccupancyLabeller((options as HarvestOptions)?.Rig?.Origin, game.Solids!, game.Surfaces!);
}
