using Harvester.Geometry;

namespace Harvester.TestSupport;

/// <summary>The truth about the edges of a road at a node, looking away from the node.</summary>
/// <param name="Node">Where the node is stored, metres, world.</param>
/// <param name="Right">Unit vector to the right.</param>
/// <param name="ToTheRight">Metres to the edge on the right.</param>
/// <param name="ToTheLeft">Metres to the edge on the left.</param>
internal readonly record struct RoadSides(Vector3D Node, Vector3D Right, double ToTheRight, double ToTheLeft)
{
    public Vector3D OnTheRight => Node + (Right * ToTheRight);

    public Vector3D OnTheLeft => Node - (Right * ToTheLeft);

    /// <summary>The distance of the one edge on the side of the other.</summary>
    public Vector3D Mirrored => Node - (Right * ToTheRight);
}
