using System.Text.Json;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Events;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Runs.Relabelling;

/// <summary>A session with the scenes and options from which its labels were made.</summary>
public sealed class RecordedSession
{
    private RecordedSession(SessionReader session, HarvestOptions options, JsonFields settings)
    {
        Session = session;
        Options = options;
        string? lookAhead = settings.OptionalText("lookAhead");
        LookAhead = lookAhead is null
            ? LookAhead.Thesis
            : LookAhead.Parse(lookAhead)
                ?? throw new DatasetFormatException(
                    $"{SessionInfo.FileName}: settings.lookAhead must be metres, or seconds such as 1s, not '{lookAhead}'."
                );
        (LaneWidthMetres, NarrowLaneWidthMetres) = LaneWidths.Of(settings);
    }

    /// <summary>The session.</summary>
    public SessionReader Session { get; }

    /// <summary>The options of the harvest. The lens is part of each scene.</summary>
    public HarvestOptions Options { get; }

    /// <summary>The look-ahead of the lane indicators.</summary>
    public LookAhead LookAhead { get; }

    /// <summary>Lane width of ordinary roads, metres.</summary>
    public double LaneWidthMetres { get; }

    /// <summary>Lane width of narrow roads, metres.</summary>
    public double NarrowLaneWidthMetres { get; }

    /// <summary>Opens a session.</summary>
    /// <exception cref="DatasetFormatException">The session has no scenes, or its session.json or table of faces is invalid.</exception>
    public static RecordedSession Open(SessionReader session)
    {
        if (!Directory.Exists(session.PathOf(FramePaths.Scenes)))
        {
            throw new DatasetFormatException(
                $"'{session.Folder}' has no {FramePaths.Scenes}: it was harvested without them, or relabelled. Relabel the original "
                    + "session."
            );
        }

        if (SessionHeader.Read(session).Shard is { } shard)
        {
            throw new DatasetFormatException(
                $"'{session.Folder}' is shard {shard} of a session. Merge the shards first, then relabel the merged session."
            );
        }

        using JsonDocument document = JsonInput.Read(session.PathOf(SessionInfo.FileName));
        var header = new JsonFields(document.RootElement);
        JsonFields options = header.Fields("options");
        string[] classes = header.Texts("classes");
        return new RecordedSession(
            session,
            options.Checked(() =>
                new HarvestOptions
                {
                    Image = session.ReadInfo().Image,
                    Rig = session.ReadInfo().Rig,
                    Format = header.Fields("image").Name<ImageFormat>("format"),
                    RangeMetres = options.Number("rangeMetres"),
                    IgnoreRangeMetres = options.OptionalNumber("ignoreRangeMetres") ?? 0,
                    Masks = options.Boolean("masks"),
                    Channels = new ChannelKeys(
                        FrameChannels
                            .All.Where(channel => channel.Switch is not null)
                            .Select(channel => channel.Key)
                            .Where(key => options.Has(key) && options.Boolean(key))
                    ),
                    Semantics = options.Has("semantics") ? options.Name<SemanticsMethod>("semantics") : null,
                    MinBoxAreaPixels = options.Number("minBoxAreaPixels"),
                    MinBoxSidePixels = options.Number("minBoxSidePixels"),
                    MaxOccludedFraction = options.Number("maxOccludedFraction"),
                    Classes = [.. classes.Select(ClassOf)],
                    Faces = Named(session, FramePaths.Faces, KeptFiles.ReadFaces),
                }
            ),
            header.Fields("settings")
        );
    }

    /// <summary>The roads in the session; null if it has none.</summary>
    /// <exception cref="DatasetFormatException">The file is invalid.</exception>
    public RoadNetwork? ReadRoads() => Named(Session, FramePaths.Roads, KeptFiles.ReadRoads);

    /// <summary>The frames with their scenes, in order.</summary>
    /// <exception cref="DatasetFormatException">A label or scene is invalid.</exception>
    /// <exception cref="IOException">A scene cannot be read.</exception>
    public IEnumerable<(FrameLabel Label, RecordedScene Scene)> Frames() => Session.ReadLabels().Select(label => (label, ReadScene(label)));

    /// <summary>The ids of its objects.</summary>
    public RecordedIds ReadIds()
    {
        var ids = new RecordedIds();
        foreach ((FrameLabel _, RecordedScene scene) in Frames())
        {
            ids.Add(scene);
        }

        foreach (EventParticipant participant in Session.ReadEvents().SelectMany(each => each.Participants))
        {
            ids.Reserve(participant.Object ?? 0);
        }

        return ids;
    }

    private RecordedScene ReadScene(FrameLabel label)
    {
        string name = FramePaths.Scene(label.Frame);
        return Named(Session, name, session => SceneParser.Read(session.PathOf(name), label));
    }

    private static ObjectClass ClassOf(string name) =>
        JsonNames.TryRead(name, out ObjectClass kind)
            ? kind
            : throw new DatasetFormatException($"{SessionInfo.FileName}: unknown class '{name}'.");

    /// <summary>Reads a file of the session; if it is invalid, the message names the file.</summary>
    private static T Named<T>(SessionReader session, string name, Func<SessionReader, T> read)
    {
        try
        {
            return read(session);
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{session.PathOf(name)}: {e.Message}", e);
        }
    }
}
