using Harvester.Runs.Faults;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Runs.Harvesting;

/// <summary>Finds the entities whose numbers changes name: the scenes of the base session have the game's handles.</summary>
public static class ChangedActors
{
    /// <summary>The changes with the handles of their entities.</summary>
    /// <param name="changes">The changes.</param>
    /// <param name="folder">The base session.</param>
    /// <exception cref="UsageException">The session has no such object.</exception>
    /// <exception cref="DatasetFormatException">A scene is invalid.</exception>
    public static IReadOnlyList<TimedChange> Resolve(IReadOnlyList<TimedChange> changes, string folder)
    {
        HashSet<int> wanted = [.. changes.Select(change => change.Id).OfType<int>()];
        Dictionary<int, int> handles = wanted.Count == 0 ? [] : HandlesIn(new SessionReader(folder), wanted);
        return
        [
            .. changes.Select(change =>
                change.Id is not { } id ? change
                : handles.TryGetValue(id, out int handle) ? change with { Change = change.Change with { Handle = handle } }
                : throw new UsageException($"--change \"{change.Text}\": no frame of the base session has an object {id}.")
            ),
        ];
    }

    private static Dictionary<int, int> HandlesIn(SessionReader session, HashSet<int> wanted)
    {
        Dictionary<int, int> handles = [];
        foreach (FrameLabel label in session.ReadLabels())
        {
            RecordedScene scene = SceneParser.Read(session.PathOf(FramePaths.Scene(label.Frame)), label);
            foreach (KeyValuePair<int, int> known in scene.Ids.Where(known => wanted.Contains(known.Value)))
            {
                handles.TryAdd(known.Value, known.Key);
            }

            if (handles.Count == wanted.Count)
            {
                break;
            }
        }

        return handles;
    }
}
