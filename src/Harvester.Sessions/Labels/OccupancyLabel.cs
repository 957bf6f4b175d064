using Harvester.Geometry;
using Harvester.Geometry.Grids;

namespace Harvester.Sessions.Labels;

/// <summary>The voxels around the ego in a frame. File format: docs/occupancy.md.</summary>
/// <param name="File">Path of the map of classes within the session, with forward slashes.</param>
/// <param name="Instances">Path of the map of objects.</param>
/// <param name="Visible">Path of the map of voxels that the camera sees.</param>
/// <param name="Shape">The size of the box of voxels.</param>
/// <param name="Origin">The origin of its frame in the frame of the ego's model, metres.</param>
public sealed record OccupancyLabel(string File, string Instances, string Visible, VoxelShape Shape, Vector3D Origin) : IChannelLabel
{
    /// <summary>The value of a voxel that the camera sees; others are 0.</summary>
    public const byte Seen = 255;

    /// <inheritdoc />
    public IEnumerable<string> Files => [File, Instances, Visible];
}
