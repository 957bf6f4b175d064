using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Ports;

/// <summary>What the picture of a simulated game truly shows.</summary>
public interface ISurfaceTruth
{
    /// <summary>Draws the classes of the current picture.</summary>
    /// <param name="image">The size of the picture, pixels.</param>
    /// <param name="classOf">The class of an entity by its handle.</param>
    InstanceMap Draw(ImageSize image, Func<int, SemanticClass> classOf);

    /// <summary>
    /// Unit normals of the surfaces in the current picture, world, row by row and on the camera's side; zero for the sky.
    /// </summary>
    /// <param name="image">The size of the picture, pixels.</param>
    IReadOnlyList<Vector3D> Normals(ImageSize image);

    /// <summary>
    /// The surfaces in the current picture, row by row, in arrays that belong to the caller: the depth along the camera's axis, metres,
    /// positive infinity for the sky; and the handle of the entity, 0 for the static world and the sky.
    /// </summary>
    /// <param name="image">The size of the picture, pixels.</param>
    (float[] Metres, int[] Entities) Surfaces(ImageSize image);
}
