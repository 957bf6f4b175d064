using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Roads;

namespace Harvester.Datasets.Roads;

/// <summary>Measures the paint of roads in the images of sessions.</summary>
public sealed class PaintSurvey
{
    private readonly RoadNetwork _network;
    private readonly PaintRoads _roads;
    private readonly PaintEvidence _evidence = new();
    private int _images;

    /// <summary>Prepares a survey.</summary>
    /// <param name="network">The roads.</param>
    public PaintSurvey(RoadNetwork network)
    {
        _network = network ?? throw new ArgumentNullException(nameof(network));
        _roads = new PaintRoads(new RoadCurves(network));
    }

    /// <summary>The roads in a session; null if it has none.</summary>
    /// <exception cref="DatasetFormatException">Its file of roads is invalid.</exception>
    public static RoadNetwork? RoadsOf(SessionReader session)
    {
        ArgumentNullException.ThrowIfNull(session);
        try
        {
            return KeptFiles.ReadRoads(session);
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{session.PathOf(Harvester.Sessions.Files.FramePaths.Roads)}: {e.Message}", e);
        }
    }

    /// <summary>Looks at the images of a session. The order of sessions and frames, not the number of processors, decides the
    /// result.</summary>
    /// <param name="session">The session.</param>
    /// <param name="report">Receives the number of images seen so far, of all sessions.</param>
    /// <exception cref="DatasetFormatException">
    /// The session is invalid, was recorded on other roads, or its cameras see none of them.
    /// </exception>
    public void Add(SessionReader session, Action<int> report)
    {
        ArgumentNullException.ThrowIfNull(session);
        ArgumentNullException.ThrowIfNull(report);
        if (RoadsOf(session) is { } recorded && !PaintCsv.SharesLinks(recorded, _network))
        {
            throw new DatasetFormatException(
                $"'{session.Folder}' was recorded on another road network. Name the one that it was recorded on with --roads."
            );
        }

        var frames = new PaintFrames(session, _roads);
        bool hasSeen = false;
        IEnumerable<PaintEvidence> found = ReadAhead.Select(
            Numbered(session.ReadLabels()),
            frame =>
            {
                var evidence = new PaintEvidence();
                new PaintScanner(_roads).Scan(frames.Of(frame.Label), frame.Number, evidence);
                return evidence;
            }
        );
        foreach (PaintEvidence evidence in found)
        {
            hasSeen |= !evidence.IsEmpty;
            _evidence.Add(evidence);
            report(++_images);
        }

        if (!hasSeen)
        {
            throw new DatasetFormatException(
                $"No camera of '{session.Folder}' sees a road of the network. Is it the network of these places?"
            );
        }
    }

    /// <summary>The paint seen so far.</summary>
    public PaintTable Measure() => PaintTableBuilder.Build(_roads, _evidence);

    private IEnumerable<(int Number, FrameLabel Label)> Numbered(IEnumerable<FrameLabel> labels)
    {
        int number = _images;
        foreach (FrameLabel label in labels)
        {
            yield return (number++, label);
        }
    }
}
