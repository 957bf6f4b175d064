using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>The body of a vehicle, as rays from outside meet it.</summary>
internal static class VehicleBody
{
    /// <summary>Distance of the start of a ray from the box of the model, metres: walls beside the vehicle are seldom nearer.</summary>
    private const double Room = 0.1;

    private static readonly Vector3D[] Sides = [new(1, 0, 0), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(0, 0, 1)];

    /// <summary>
    /// Whether a point is inside: in the box of the model, and with the vehicle ahead, behind, on both sides and above. Rays are cast from
    /// the sides of the box towards the point, because a ray that starts inside a body may leave it unnoticed.
    /// </summary>
    /// <param name="ego">The vehicle.</param>
    /// <param name="point">The point in the frame of the vehicle's model, metres.</param>
    /// <param name="rays">Rays, which meet the vehicle.</param>
    public static bool Encloses(EgoState ego, Vector3D point, IRayCaster rays) =>
        IsBetween(ego.ModelMin, point, ego.ModelMax)
        && Array.TrueForAll(
            Sides,
            side =>
            {
                Vector3D corner = new(
                    side.X > 0 ? ego.ModelMax.X : ego.ModelMin.X,
                    side.Y > 0 ? ego.ModelMax.Y : ego.ModelMin.Y,
                    ego.ModelMax.Z
                );
                double distance = Math.Abs((corner - point).Dot(side)) + Room;
                var ray = new Ray(ego.Pose.ToWorld(point + (side * distance)), ego.Pose.Axes.ToWorld(side * -1));
                return rays.Cast(ray, distance, RayHit.World)?.Entity == ego.Handle;
            }
        );

    private static bool IsBetween(Vector3D low, Vector3D point, Vector3D high) =>
        point.X > low.X && point.X < high.X && point.Y > low.Y && point.Y < high.Y && point.Z > low.Z && point.Z < high.Z;
}
