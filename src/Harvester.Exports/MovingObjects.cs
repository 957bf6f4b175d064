using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports;

/// <summary>Which objects move.</summary>
internal static class MovingObjects
{
    /// <summary>
    /// Speed from which an object counts as moving, m/s: slower than walking, faster than the sway of a person who stands.
    /// </summary>
    private const double Speed = 0.2;

    /// <summary>Whether an object moves.</summary>
    /// <param name="speed">Its speed, m/s.</param>
    public static bool IsMoving(double speed) => speed > Speed;

    /// <summary>
    /// The ids of the objects that move at a frame: those of its scene, which has all around the vehicle or, in a session without scenes,
    /// those in its image.
    /// </summary>
    /// <exception cref="DatasetFormatException">The scene is damaged.</exception>
    public static HashSet<int> At(ExportFrame frame)
    {
        HashSet<int> moving = [.. frame.Label.Objects.Where(item => IsMoving(item.Velocity.Length)).Select(item => item.Id)];
        if (frame.Scene is { } scene)
        {
            HashSet<int> handles =
            [
                .. scene.Snapshot.Entities.Where(entity => IsMoving(entity.Velocity.Length)).Select(entity => entity.Handle),
            ];
            moving.UnionWith(scene.Ids.Where(id => handles.Contains(id.Key)).Select(id => id.Value));
        }

        return moving;
    }
}
