using Harvester.Geometry.Grids;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Ports;

/// <summary>The surfaces of everything that is drawn around the vehicle, seen or not.</summary>
public interface ISolids
{
    /// <summary>
    /// Fills a box of voxels with the surfaces of the current picture, without the vehicle's own; its owners are the handles of entities.
    /// </summary>
    /// <param name="grid">The box.</param>
    /// <param name="ranks">Which of several classes in a voxel counts: that of the greatest rank.</param>
    /// <param name="classOf">The class of an entity by its handle.</param>
    VoxelMap Fill(VoxelGrid grid, IReadOnlyList<byte> ranks, Func<int, SemanticClass> classOf);
}
