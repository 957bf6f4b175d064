using Harvester.Runs.Faults;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Runs.Harvesting;

/// <summary>
/// Finds what changes name: the scenes of the base session have the game's handles of numbered objects, and its record of the scenario
/// those of actors and when events began.
/// </summary>
public static class ChangedActors
{
    /// <summary>The changes with the handles of their entities.</summary>
    /// <param name="changes">The changes.</param>
    /// <param name="folder">The base session.</param>
    /// <exception cref="UsageException">The session has no such object, frame, actor or event.</exception>
    /// <exception cref="DatasetFormatException">A scene or the record of the scenario is invalid.</exception>
    public static IReadOnlyList<TimedChange> Resolve(IReadOnlyList<TimedChange> changes, string folder)
    {
        HashSet<int> wanted = [.. changes.Select(change => change.Id).OfType<int>()];
        Dictionary<int, int> handles = wanted.Count == 0 ? [] : HandlesIn(new SessionReader(folder), wanted);
        StagedBase? staged = changes.Any(change => change.Actor is not null || change.Event is not null) ? StagedBase.Read(folder) : null;
        return
        [
            .. changes
                .Select(change =>
                    change.Id is not { } id ? change
                    : handles.TryGetValue(id, out int handle) ? For(change, handle)
                    : throw new UsageException($"--change \"{change.Text}\": no frame of the base session has an object {id}.")
                )
                .Select(change =>
                    change.Actor is not { } actor ? change
                    : staged!.Actors.TryGetValue(actor, out int handle) ? For(change, handle)
                    : throw new UsageException($"--change \"{change.Text}\": the base session has no actor '{actor}'.")
                )
                .Select(change =>
                    change.Event is not { } id ? change
                    : staged!.Begun.TryGetValue(id, out long frame) ? change with { GameFrame = frame }
                    : throw new UsageException($"--change \"{change.Text}\": the event '{id}' did not begin in the base session.")
                ),
        ];
    }

    private static TimedChange For(TimedChange change, int handle) => change with { Change = change.Change with { Handle = handle } };

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
