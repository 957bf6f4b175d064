using Harvester.Geometry;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Props;

/// <summary>The traffic lights and signs in the scenes of a session: those that came within its labelling range.</summary>
public static class SessionProps
{
    /// <summary>Props of one model whose places agree to this distance are one, metres.</summary>
    private const double SamePlace = 0.1;

    /// <summary>Reads the lights and signs, each once, in the order in which the session meets them.</summary>
    /// <exception cref="DatasetFormatException">A label or scene is invalid, or the session has no scenes; the message names the
    /// file.</exception>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public static IReadOnlyList<PropPlacement> Of(SessionReader session)
    {
        ArgumentNullException.ThrowIfNull(session);
        var props = new Dictionary<(string, double, double, double), PropPlacement>();
        foreach (FrameLabel label in session.ReadLabels())
        {
            foreach (EntityState entity in SceneOf(session, label).Snapshot.Entities)
            {
                if (entity.Class is ObjectClass.Sign or ObjectClass.TrafficLight)
                {
                    Vector3D place = entity.Pose.Position;
                    props.TryAdd(
                        (entity.Model, Rounded(place.X), Rounded(place.Y), Rounded(place.Z)),
                        new PropPlacement(entity.Model, place, entity.Pose.Axes.ToEuler())
                    );
                }
            }
        }

        return [.. props.Values];
    }

    private static double Rounded(double metres) => Math.Round(metres / SamePlace);

    private static RecordedScene SceneOf(SessionReader session, FrameLabel label)
    {
        string file = session.PathOf(FramePaths.Scene(label.Frame));
        if (!File.Exists(file))
        {
            throw new DatasetFormatException($"{file} is missing. A session recorded with --no-scenes gives no lights and signs.");
        }

        try
        {
            return SceneParser.Read(file, label);
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{file}: {e.Message}", e);
        }
    }
}
