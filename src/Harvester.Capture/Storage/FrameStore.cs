using System.Diagnostics;
using System.Text;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Sessions.Events;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Storage;

/// <summary>
/// Writes frames so that a label line is on the disk only after all that it stands for: a frame's files are written at once, and its lines
/// are held back until the files of a batch of frames are on the disk; then the lines of the manifest are written, then those of the
/// labels.
/// </summary>
/// <param name="files">The session's files.</param>
/// <param name="mode">When to wait for the disk.</param>
/// <param name="pictures">Encodes images.</param>
/// <param name="keepsManifest">Whether the session has a manifest.</param>
/// <param name="viewsPerMoment">Number of frames of a moment, whose lines are written together.</param>
/// <param name="writtenEvents">Number of events at the beginning that an earlier run of the same course has written.</param>
internal sealed class FrameStore(
    ISessionFiles files,
    SyncMode mode,
    PictureEncoder pictures,
    bool keepsManifest,
    int viewsPerMoment,
    int writtenEvents = 0
)
{
    private readonly PngEncoder _png = new();
    private readonly List<string> _manifestLines = [];
    private readonly List<string> _labelLines = [];
    private readonly Stopwatch _age = new();
    private readonly List<int> _frames = [];
    private readonly List<string> _eventLines = [];
    private int _eventsToSkip = writtenEvents;
    private int _committed;

    /// <summary>Frames whose label lines are written.</summary>
    public int Committed => Volatile.Read(ref _committed);

    /// <summary>Number of the last frame whose label line is written; -1 for none.</summary>
    public int LastCommitted { get; private set; } = -1;

    /// <summary>How long to wait for another frame before the lines held back are due; infinite when none are.</summary>
    public TimeSpan Patience =>
        _labelLines.Count < viewsPerMoment ? Timeout.InfiniteTimeSpan
        : _age.Elapsed < SyncBatch.MaxAge ? SyncBatch.MaxAge - _age.Elapsed
        : TimeSpan.Zero;

    private bool IsDurable => mode != SyncMode.Never;

    /// <summary>Writes a text that belongs to no single frame, in place of an older one.</summary>
    public void WriteText(string name, string text)
    {
        // While it is replaced, the manifest has the lines of both, so that it is right at every moment.
        AppendToManifest([Manifest.FileLine(name, FileDigest.Of(text))]);
        byte[] bytes = new UTF8Encoding(false).GetBytes(text);
        files.WriteWhole(name, stream => stream.Write(bytes, 0, bytes.Length));
    }

    /// <summary>Rewrites the manifest, once all lines are written or before the first of them.</summary>
    /// <param name="isFrame">Says by its number whether a frame is part of the session.</param>
    /// <param name="keepsReplaced">Whether lines of files that were replaced since stay too.</param>
    public void TidyManifest(Predicate<int> isFrame, bool keepsReplaced)
    {
        if (keepsManifest)
        {
            files.TidyManifest(isFrame, keepsReplaced, IsDurable);
        }
    }

    /// <summary>Brings to the disk what was written beside frames.</summary>
    public void Sync()
    {
        if (IsDurable)
        {
            files.Sync();
        }
    }

    /// <summary>
    /// Writes a frame's files, and the lines held back when they are due. After a failure of the lines their frames are given up: a disk
    /// that could not keep a file does not say so twice.
    /// </summary>
    /// <param name="frame">The frame; null if none has come, so that all lines of whole moments are due.</param>
    public void Write(CapturedFrame? frame)
    {
        if (frame is not null)
        {
            var written = new List<KeyValuePair<string, FileDigest>>
            {
                new(frame.Label.Image, files.WriteWhole(frame.Label.Image, stream => pictures.Write(frame.Picture, stream))),
            };
            if (frame is { Label.Mask: { } path, Mask: { } mask })
            {
                written.Add(new(path, files.WriteWhole(path, stream => _png.Write(mask, stream))));
            }

            foreach (string folder in frame.Folders)
            {
                files.MakeFolder(folder);
            }

            foreach (FrameFile file in frame.Files)
            {
                written.Add(new(file.Path, files.WriteWhole(file.Path, stream => file.Content(stream, _png))));
            }

            if (frame.Scene is { } scene)
            {
                string name = FramePaths.Scene(frame.Label.Frame);
                byte[] bytes = new UTF8Encoding(false).GetBytes(SceneJson.Text(scene));
                written.Add(new(name, files.WriteWhole(name, stream => stream.Write(bytes, 0, bytes.Length))));
            }

            string line = JsonLabelWriter.Line(frame.Label);
            if (_labelLines.Count == 0)
            {
                _age.Restart();
            }

            _manifestLines.Add(Manifest.FrameLine(frame.Label.Frame, FileDigest.Of(line), written));
            _labelLines.Add(line);
            _frames.Add(frame.Label.Frame);
            AddEvents(frame.EndedEvents);
            if (mode == SyncMode.Batch && _labelLines.Count < SyncBatch.MaxFrames && _age.Elapsed < SyncBatch.MaxAge)
            {
                return;
            }
        }

        int whole = _labelLines.Count - (_labelLines.Count % viewsPerMoment);
        if (whole == 0)
        {
            return;
        }

        List<string> manifestLines = _manifestLines.GetRange(0, whole);
        List<string> labelLines = _labelLines.GetRange(0, whole);
        int last = _frames[whole - 1];
        _manifestLines.RemoveRange(0, whole);
        _labelLines.RemoveRange(0, whole);
        _frames.RemoveRange(0, whole);
        Sync();
        AppendToManifest(manifestLines);
        files.Append(SessionDirectory.Labels, labelLines, IsDurable);
        AppendEvents();
        LastCommitted = last;
        Volatile.Write(ref _committed, _committed + whole);
    }

    /// <summary>Writes the last events, after all frames, and the line of their file in the manifest.</summary>
    public void FinishEvents(IReadOnlyList<DrivingEvent> events)
    {
        AddEvents(events);
        files.Append(FramePaths.Events, [], IsDurable);
        AppendEvents();
        AppendToManifest([Manifest.FileLine(FramePaths.Events, files.DigestOf(FramePaths.Events))]);
    }

    private void AddEvents(IReadOnlyList<DrivingEvent> events)
    {
        int skipped = Math.Min(_eventsToSkip, events.Count);
        _eventsToSkip -= skipped;
        _eventLines.AddRange(events.Skip(skipped).Select(EventJson.Line));
    }

    /// <summary>Writes the events held back. All their frames come before the frames that brought them.</summary>
    private void AppendEvents()
    {
        if (_eventLines.Count > 0)
        {
            files.Append(FramePaths.Events, _eventLines, IsDurable);
            _eventLines.Clear();
        }
    }

    private void AppendToManifest(IReadOnlyList<string> lines)
    {
        if (keepsManifest)
        {
            files.Append(Manifest.FileName, lines, IsDurable);
        }
    }
}
