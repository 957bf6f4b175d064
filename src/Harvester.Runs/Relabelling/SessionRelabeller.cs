using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Datasets.Derivation;
using Harvester.Datasets.Files;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Scenes;

namespace Harvester.Runs.Relabelling;

/// <summary>Creates a new session from a recorded one, with the same images and new labels. docs/relabel.md describes each field.</summary>
public sealed class SessionRelabeller
{
    private readonly RecordedSession _recorded;
    private readonly RelabelOptions _changes;
    private readonly HarvestOptions _options;
    private readonly PngEncoder _png = new();

    /// <summary>Prepares relabelling.</summary>
    /// <param name="session">A harvested session with scenes.</param>
    /// <param name="changes">The options to change.</param>
    /// <exception cref="DatasetFormatException">The session has no scenes or is invalid, or lacks data that the options need.</exception>
    public SessionRelabeller(SessionReader session, RelabelOptions changes)
    {
        _recorded = RecordedSession.Open(session);
        _changes = changes ?? throw new ArgumentNullException(nameof(changes));
        HarvestOptions recorded = _recorded.Options;
        if (recorded.Rig is not null && changes.Lens is not null)
        {
            throw new DatasetFormatException(
                $"'{session.Folder}' was harvested with a rig, which gives each camera its lens. Leave out the options of the lens."
            );
        }

        if (changes.RangeMetres > recorded.RangeMetres)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant(
                    $"'{session.Folder}' was recorded up to {recorded.RangeMetres} m. Use at most this range, or harvest again."
                )
            );
        }

        _options = recorded with
        {
            RangeMetres = changes.RangeMetres ?? recorded.RangeMetres,
            Classes = changes.Classes ?? recorded.Classes,
            MinBoxAreaPixels = changes.MinBoxAreaPixels ?? recorded.MinBoxAreaPixels,
            MinBoxSidePixels = changes.MinBoxSidePixels ?? recorded.MinBoxSidePixels,
            MaxOccludedFraction = changes.MaxOccludedFraction ?? recorded.MaxOccludedFraction,
            Faces = changes.Faces is { } faces ? recorded.Faces?.OverriddenBy(faces) ?? faces : recorded.Faces,
            Shard = changes.Shard,
        };
    }

    /// <summary>Writes the new session.</summary>
    /// <param name="folder">Folder to write to: new, empty, or with what a stopped run left that is resumed.</param>
    /// <param name="report">Receives the number of frames after each frame.</param>
    /// <param name="cancellation">Stops between two frames; no session is left then, but perhaps frames to resume from.</param>
    /// <returns>The number of frames.</returns>
    /// <exception cref="DatasetFormatException">A label or scene is invalid, or all object ids are used up.</exception>
    /// <exception cref="OccupiedFolderException">The folder is not empty.</exception>
    /// <exception cref="IOException">A file cannot be read or written.</exception>
    public int Run(string folder, Action<int> report, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(report);
        if (Directory.Exists(folder) && !UnfinishedMark.IsAllOf(folder) && !(_changes.Resume && UnfinishedMark.IsIn(folder)))
        {
            throw new OccupiedFolderException($"'{folder}' is not empty. Name another folder.");
        }

        RecordedIds ids = _recorded.ReadIds();
        (IRoads? roads, IRoadPaint? paint) = RoadsOf();
        RelabelStart? start = null;
        int position = 0;
        int frames = 0;
        using var digests = new CarriedDigests(_recorded.Session);
        string key = RelabelKey.Of(_recorded.Session, _changes);
        NewSession.Write(
            folder,
            _changes.Sync,
            key,
            _changes.Resume,
            _changes.MinFreeBytes,
            session =>
            {
                foreach ((FrameLabel label, RecordedScene scene) in _recorded.Frames())
                {
                    cancellation.ThrowIfCancellationRequested();
                    start ??= StartAt(scene, label, ids, roads, paint);
                    bool isOurs = _changes.Shard.Takes(position++ / _options.ViewsPerMoment);
                    if (!isOurs || frames < session.Resumed)
                    {
                        Checked(() => start.Labeller.Pass(scene, label));
                        frames += isOurs ? 1 : 0;
                        continue;
                    }

                    FrameLabel made = label;
                    Checked(() => made = start.Labeller.Relabel(scene, label, () => Picture(label)));
                    PlaceFiles(session, digests, label, made);
                    session.EndFrame(made.Frame, JsonLabelWriter.Line(made));
                    report(++frames);
                }

                string[] others = [FramePaths.Events, ScenarioRecord.FileName];
                foreach (string name in others.Where(name => File.Exists(_recorded.Session.PathOf(name))))
                {
                    session.Place(name, _recorded.Session, _changes.Images, () => digests.Of(name));
                }
            },
            () => HeaderOf(start, frames)
        );
        return frames;
    }

    /// <summary>
    /// The number of frames in a finished result of this relabelling: its session.json, the number of its labels and its first label are
    /// those that a run would write.
    /// </summary>
    /// <param name="folder">The folder.</param>
    /// <returns>Null if the folder has no such result.</returns>
    /// <exception cref="DatasetFormatException">A label or scene of the recorded session is invalid.</exception>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public int? FramesOfFinished(string folder)
    {
        string header = Path.Combine(folder, SessionInfo.FileName);
        if (!File.Exists(header) || UnfinishedMark.IsIn(folder))
        {
            return null;
        }

        int views = _options.ViewsPerMoment;
        int frames = Enumerable.Range(0, _recorded.Session.CountLines()).Count(place => _changes.Shard.Takes(place / views));
        var finished = new SessionReader(folder);
        if (finished.CountLines() != frames)
        {
            return null;
        }

        RecordedIds ids = _recorded.ReadIds();
        (IRoads? roads, IRoadPaint? paint) = RoadsOf();
        RelabelStart? start = null;
        string? first = null;
        int position = 0;
        foreach ((FrameLabel label, RecordedScene scene) in _recorded.Frames())
        {
            start ??= StartAt(scene, label, ids, roads, paint);
            if (_changes.Shard.Takes(position++ / views))
            {
                Checked(() => first = JsonLabelWriter.Line(start.Labeller.Relabel(scene, label, () => Picture(label))));
                break;
            }

            Checked(() => start.Labeller.Pass(scene, label));
        }

        return InputFile.ReadAllText(header) == HeaderOf(start, frames) && finished.ReadTexts().FirstOrDefault() == first ? frames : null;
    }

    /// <summary>What the first frame decides for all.</summary>
    private RelabelStart StartAt(RecordedScene scene, FrameLabel label, RecordedIds ids, IRoads? roads, IRoadPaint? paint)
    {
        Lens lens = _changes.Lens ?? scene.Lens;
        ChannelLabels kept = scene.Lens == lens ? label.Channels : label.Channels.WithoutLens();
        HarvestOptions options = _options with
        {
            Lens = lens,
            Masks = _recorded.Options.Masks && FrameRelabeller.KeepsMask(scene, label, lens),
            Channels = new ChannelKeys(
                FrameChannels
                    .All.Where(channel => channel.LabelIn(kept) is not null)
                    .Select(channel => channel.Key)
                    .Intersect(_recorded.Options.Channels.Keys)
            ),
            Semantics = kept.Get<ClassMapLabel>() is null ? null : _recorded.Options.Semantics,
        };
        return new RelabelStart(new FrameRelabeller(_options with { Lens = lens }, _recorded.Options, ids, roads, paint), options);
    }

    private string HeaderOf(RelabelStart? start, int frames) =>
        new RelabelledHeader(_recorded, _changes, start?.Options ?? _options with { Lens = Lens.Ideal }).Text(frames);

    private static void Checked(Action label)
    {
        try
        {
            label();
        }
        catch (HarvestFaultException e)
        {
            throw new DatasetFormatException(e.Message, e);
        }
    }

    private (IRoads? Roads, IRoadPaint? Paint) RoadsOf()
    {
        if ((_changes.Roads ?? _recorded.ReadRoads()) is { } network)
        {
            string source = _changes.Roads is null ? "simulation" : "roadFile";
            return (Fixed(network, source), _changes.Paint is { } paint ? new MeasuredPaint(paint) : null);
        }

        return _changes is { LookAhead: null, LaneWidthMetres: null, NarrowLaneWidthMetres: null }
            ? (null, null)
            : throw new DatasetFormatException(
                $"'{_recorded.Session.Folder}' has no recorded roads. To measure other lanes, name a road network with --roads."
            );
    }

    private FixedRoads Fixed(RoadNetwork roads, string source) =>
        new(
            roads,
            source,
            _changes.LookAhead ?? _recorded.LookAhead,
            _changes.LaneWidthMetres ?? _recorded.LaneWidthMetres,
            _changes.NarrowLaneWidthMetres ?? _recorded.NarrowLaneWidthMetres,
            _changes.Paint
        );

    private PixelBuffer Picture(FrameLabel label)
    {
        try
        {
            return PictureReader.Read(_recorded.Session.PathOf(label.Image));
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{_recorded.Session.PathOf(label.Image)} cannot be read: {e.Message}", e);
        }
    }

    private void PlaceFiles(NewSession session, CarriedDigests digests, FrameLabel recorded, FrameLabel made)
    {
        Place(recorded.Image);
        foreach (string file in made.Channels.Files)
        {
            Place(file);
        }

        if (made.Mask is not { } mask)
        {
            return;
        }

        var kept = made.Objects.Select(item => item.Id).ToHashSet();
        if (recorded.Objects.All(item => kept.Contains(item.Id) || item.Parent is not null))
        {
            Place(mask);
            return;
        }

        InstanceMap map = PngDecoder.ReadInstanceMap(_recorded.Session.PathOf(mask));
        for (int i = 0; i < map.Ids.Length; i++)
        {
            map.Ids[i] = kept.Contains(map.Ids[i]) ? map.Ids[i] : (ushort)0;
        }

        session.WriteFile(mask, file => _png.Write(map, file));

        void Place(string name) => session.Place(name, _recorded.Session, _changes.Images, () => digests.Of(recorded.Frame, name));
    }
}
