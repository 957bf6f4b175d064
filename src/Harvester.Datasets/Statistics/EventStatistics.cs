using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Statistics;

/// <summary>How many events sessions have, and how far the ego drove in the frames that name events.</summary>
public sealed class EventStatistics
{
    /// <summary>Between two frames of a place, a car does not move this far; it was repositioned, metres.</summary>
    private const double JumpMetres = 100;

    private readonly SortedDictionary<EventKind, int> _counts = [];

    /// <summary>Number of events by kind; only kinds that occur.</summary>
    public IReadOnlyDictionary<EventKind, int> Counts => _counts;

    /// <summary>Sum of the straight distances between successive frames, kilometres, without changes of place.</summary>
    public double Kilometres { get; private set; }

    /// <summary>Whether a session records events.</summary>
    public bool AreRecorded { get; private set; }

    /// <summary>The labels of a session, whose distances are added while they are read, and its events after the last label.</summary>
    /// <exception cref="DatasetFormatException">A line of the session is invalid.</exception>
    public IEnumerable<FrameLabel> Observed(SessionReader session)
    {
        ArgumentNullException.ThrowIfNull(session);
        FrameLabel? before = null;
        foreach (FrameLabel label in session.ReadLabels())
        {
            if (label.Events is not null)
            {
                AreRecorded = true;
                Vector3D moved = before is null ? Vector3D.Zero : label.Ego.Position - before.Ego.Position;
                Kilometres += before?.Place == label.Place && moved.Length <= JumpMetres ? moved.Length / 1000 : 0;
            }

            before = label;
            yield return label;
        }

        foreach (DrivingEvent happened in session.ReadEvents())
        {
            _counts[happened.Kind] = _counts.GetValueOrDefault(happened.Kind) + 1;
        }
    }
}
