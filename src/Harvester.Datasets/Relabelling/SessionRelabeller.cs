using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Datasets.Files;
using Harvester.Datasets.Images;
using Harvester.Datasets.Sessions;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Relabelling;

/// <summary>
/// Makes a new session of a recorded one: the same pictures, with labels made again in another way. docs/relabel.md says what of each.
/// </summary>
public sealed class SessionRelabeller
{
    private readonly RecordedSession _recorded;
    private readonly RelabelOptions _changes;
    private readonly HarvestOptions _options;
    private readonly PngEncoder _png = new();

    /// <summary>Prepares.</summary>
    /// <param name="session">A session as harvested, with its scenes.</param>
    /// <param name="changes">What is to be otherwise.</param>
    /// <exception cref="DatasetFormatException">The session has no scenes or is malformed, or does not hold what is asked for.</exception>
    public SessionRelabeller(SessionReader session, RelabelOptions changes)
    {
        _recorded = RecordedSession.Open(session);
        _changes = changes ?? throw new ArgumentNullException(nameof(changes));
        HarvestOptions recorded = _recorded.Options;
        if (changes.RangeMetres > recorded.RangeMetres)
        {
            throw new DatasetFormatException(FormattableString.Invariant(
                $"'{session.Folder}' was recorded up to {recorded.RangeMetres} m, so nothing is known beyond. Use a range of {recorded.RangeMetres} m at most, or harvest again with a larger one."));
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

    /// <summary>Makes the new session.</summary>
    /// <param name="folder">Where it goes: a new or empty folder.</param>
    /// <param name="report">Is told the number of frames done after each.</param>
    /// <param name="cancellation">Stops between two frames and leaves no session.</param>
    /// <returns>The number of frames.</returns>
    /// <exception cref="DatasetFormatException">A label or scene is malformed, or all object numbers are used up.</exception>
    /// <exception cref="OccupiedFolderException">The folder is not empty.</exception>
    /// <exception cref="IOException">Something cannot be read or written.</exception>
    public int Run(string folder, Action<int> report, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(report);
        if (Directory.Exists(folder) && Directory.EnumerateFileSystemEntries(folder).Any())
        {
            throw new OccupiedFolderException($"'{folder}' is not empty. Name another folder.");
        }

        RecordedIds ids = _recorded.ReadIds();
        IRoads? roads = RoadsOf();
        FrameRelabeller? labeller = null;
        Lens lens = Lens.Ideal;
        int position = 0;
        int frames = 0;
        bool masks = _recorded.Options.Masks;
        Directory.CreateDirectory(folder);
        AtomicFile.Write(Path.Combine(folder, SessionReader.LabelsFile), file =>
        {
            using var lines = new StreamWriter(file, new UTF8Encoding(false), leaveOpen: true) { NewLine = "\n" };
            foreach ((FrameLabel label, RecordedScene scene) in _recorded.Frames())
            {
                cancellation.ThrowIfCancellationRequested();
                if (labeller is null)
                {
                    lens = _changes.Lens ?? scene.Lens;
                    masks = masks && FrameRelabeller.KeepsMask(scene, label, lens);
                    labeller = new FrameRelabeller(_options with { Lens = lens }, _recorded.Options, ids, roads);
                }

                if (!_changes.Shard.Takes(position++))
                {
                    Checked(() => labeller.Pass(scene));
                    continue;
                }

                FrameLabel made = label;
                Checked(() => made = labeller.Relabel(scene, label, () => Picture(label)));
                PlaceFiles(folder, label, made);
                lines.WriteLine(JsonLabelWriter.Line(made));
                report(++frames);
            }
        });
        new RelabelledHeader(_recorded, _changes, _options with { Lens = lens, Masks = masks }).Write(folder, frames);
        return frames;
    }

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

    private FixedRoads? RoadsOf()
    {
        if (_changes.Roads is { } roads)
        {
            return Fixed(roads, "roadFile");
        }

        if (_recorded.ReadRoads() is { } recorded)
        {
            return Fixed(recorded, "simulation");
        }

        return _changes.LookAhead is null && _changes.LaneWidthMetres is null && _changes.NarrowLaneWidthMetres is null
            ? null
            : throw new DatasetFormatException($"'{_recorded.Session.Folder}' has no recorded roads. To measure other lanes, name a road network with --roads.");
    }

    private FixedRoads Fixed(RoadNetwork roads, string source) => new(
        roads,
        source,
        _changes.LookAhead ?? _recorded.LookAhead,
        _changes.LaneWidthMetres ?? _recorded.LaneWidthMetres,
        _changes.NarrowLaneWidthMetres ?? _recorded.NarrowLaneWidthMetres);

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

    private void PlaceFiles(string folder, FrameLabel recorded, FrameLabel made)
    {
        Place(folder, recorded.Image);
        if (made.Mask is not { } mask)
        {
            return;
        }

        var kept = made.Objects.Select(item => item.Id).ToHashSet();
        if (recorded.Objects.All(item => kept.Contains(item.Id) || item.Parent is not null))
        {
            Place(folder, mask);
            return;
        }

        InstanceMap map = PngDecoder.ReadInstanceMap(_recorded.Session.PathOf(mask));
        for (int i = 0; i < map.Ids.Length; i++)
        {
            map.Ids[i] = kept.Contains(map.Ids[i]) ? map.Ids[i] : (ushort)0;
        }

        AtomicFile.Write(Prepare(folder, mask), file => _png.Write(map, file));
    }

    private void Place(string folder, string name)
    {
        FileTransfer.Place(Prepare(folder, name), _recorded.Session.PathOf(name), _changes.Images);
    }

    private static string Prepare(string folder, string name)
    {
        string target = InnerPath.Of(folder, name);
        Directory.CreateDirectory(Path.GetDirectoryName(target)!);
        return target;
    }
}
