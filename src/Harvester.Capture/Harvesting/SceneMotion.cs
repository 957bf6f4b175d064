using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>Measures how much camera and entities move between two readings, in proportion to what an image shows of it.</summary>
internal static class SceneMotion
{
    /// <summary>Distance at which a rotation of the camera counts as movement, metres: that of most of what a street scene shows.</summary>
    private const double RotationArmMetres = 10;

    /// <summary>Minimum distance of an entity in this measure, metres, so that one beside the camera does not dominate.</summary>
    private const double MinMetres = 5;

    /// <summary>Movement and rotation of the camera, metres.</summary>
    public static double OfCamera(SceneSnapshot before, SceneSnapshot after)
    {
        Pose a = before.Camera.Pose;
        Pose b = after.Camera.Pose;
        return (b.Position - a.Position).Length
            + (RotationArmMetres * ((b.Axes.Forward - a.Axes.Forward).Length + (b.Axes.Right - a.Axes.Right).Length));
    }

    /// <summary>The sum of the angles by which entities in both readings move as seen from the camera, radians.</summary>
    public static double OfEntities(SceneSnapshot before, SceneSnapshot after)
    {
        Dictionary<int, Pose> known = before.Entities.ToDictionary(entity => entity.Handle, entity => entity.Pose);
        Vector3D eye = after.Camera.Pose.Position;
        double sum = 0;
        foreach (EntityState entity in after.Entities)
        {
            if (known.TryGetValue(entity.Handle, out Pose pose))
            {
                sum += (entity.Pose.Position - pose.Position).Length / Math.Max(MinMetres, (entity.Pose.Position - eye).Length);
            }
        }

        return sum;
    }
}
