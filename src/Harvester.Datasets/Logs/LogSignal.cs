using Harvester.Geometry;

namespace Harvester.Datasets.Logs;

/// <summary>What a light tells a lane at one step.</summary>
/// <param name="Lane">Id of the lane.</param>
/// <param name="Light">The light.</param>
/// <param name="Stop">Where the lane's traffic waits, metres, world.</param>
internal sealed record LogSignal(long Lane, LogLight Light, Vector3D Stop);
