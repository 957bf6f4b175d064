using System.Collections.Concurrent;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Storage;

/// <summary>
/// Writes a session to disk on a thread of its own, behind a bounded queue. A frame's image and mask are written under temporary names,
/// renamed and flushed to the disk; then its label line is appended, which makes the frame part of the session. If the disk fails,
/// <see cref="Fault"/> says so, and what was written stays valid.
/// </summary>
public sealed class SessionWriter : IFrameSink
{
    private readonly SessionOrigin _origin;
    private readonly ISessionFiles _files;
    private readonly IFreeSpace? _disk;
    private readonly SessionContent _before;
    private readonly List<KeyValuePair<string, string>> _kept = [];
    private readonly List<KeyValuePair<string, Func<string>>> _keptAtEnd = [];
    private FrameStore? _store;
    private HeaderFile? _header;
    private SpaceWatch? _space;
    private BlockingCollection<CapturedFrame>? _queue;
    private Thread? _thread;
    private SessionStart? _start;
    private volatile SessionEnd? _end;
    private volatile string? _fault;
    private volatile bool _isSpaceLow;

    /// <summary>Creates a writer for a new session.</summary>
    /// <param name="directory">The session's directory. It is created if it does not exist, and must otherwise be empty except for an
    /// <see cref="UnfinishedMark"/>.</param>
    /// <param name="origin">Where the session comes from.</param>
    /// <param name="resume">Whether to resume a session that the directory holds; its frames are kept and new ones are appended.</param>
    /// <param name="viewsPerMoment">Number of frames of a moment; an incomplete last moment of a resumed session is dropped.</param>
    /// <exception cref="IOException">
    /// The directory is not empty, has a link in place of a folder of frames, or cannot be created or read.
    /// </exception>
    /// <exception cref="UnauthorizedAccessException">The directory is not writable.</exception>
    public SessionWriter(string directory, SessionOrigin origin, bool resume = false, int viewsPerMoment = 1)
        : this(directory, origin, resume, new SessionDirectory(directory), viewsPerMoment) { }

    internal SessionWriter(
        string directory,
        SessionOrigin origin,
        bool resume,
        ISessionFiles files,
        int viewsPerMoment = 1,
        IFreeSpace? disk = null
    )
    {
        _disk = disk;
        Folder = directory;
        _origin = origin ?? throw new ArgumentNullException(nameof(origin));
        _files = files;
        Directory.CreateDirectory(directory);
        if (!resume && !UnfinishedMark.IsAllOf(directory))
        {
            throw new IOException($"The directory '{directory}' is not empty. Name another, or ask to resume the session in it.");
        }

        foreach (string folder in InnerFolders())
        {
            AppendedFile.RefuseLink(folder);
        }

        _before = resume ? SessionContent.Read(directory, viewsPerMoment) : SessionContent.Nothing;
        AtomicFile.DeleteLeftovers(directory, _ => true);
        foreach (string folder in InnerFolders())
        {
            AtomicFile.DeleteLeftovers(folder, _ => true);
        }
    }

    /// <summary>
    /// Whether a resumed session is harvested from its beginning again, by a game whose course is the same in every run: frames and objects
    /// keep their numbers, and frames up to <see cref="RecordedThrough"/> must not be enqueued. By default, new frames follow the old ones.
    /// </summary>
    public bool Replays { get; init; }

    /// <summary>Number of the last frame that the resumed session holds; -1 for none.</summary>
    public int RecordedThrough => _before.LastFrame;

    /// <summary>The session's directory, as it was given.</summary>
    public string Folder { get; }

    /// <summary>
    /// What keeps others from writing to the directory, released when the session is closed; null where the caller holds it.
    /// </summary>
    public WriterLock? Lock { get; init; }

    /// <summary>
    /// Whether the directory, which must be new, is removed when the writer is disposed before <see cref="Open"/>, or after a fault without
    /// any frame taken or discarded, so that a harvest that failed to start leaves none. A directory with anything else in it stays.
    /// </summary>
    public bool RemovesFailedStart { get; init; }

    /// <inheritdoc />
    public string? Fault => _fault;

    /// <summary>Whether the fault is that little space is left on the disk, which still takes what is written.</summary>
    public bool IsSpaceLow => _isSpaceLow;

    /// <inheritdoc />
    public int FirstFrame => Replays ? 0 : Math.Max(_before.Frames, _before.LastFrame + 1);

    /// <inheritdoc />
    public int FirstObjectId => Replays ? 1 : _before.MaxObjectId + 1;

    /// <inheritdoc />
    public int FirstEventId => Replays ? 1 : _before.MaxEventId + 1;

    /// <summary>Frames of the session whose label lines are written, including those of earlier runs.</summary>
    public int FramesWritten => _before.Frames + (_store?.Committed ?? 0);

    /// <summary>Frames accepted and not written yet.</summary>
    public int Queued => _queue?.Count ?? 0;

    /// <summary>Whether a session.json is that of a session from the same origin and with the same options, finished or not.</summary>
    /// <param name="text">Content of the file.</param>
    /// <param name="origin">The origin.</param>
    /// <param name="options">The options.</param>
    public static bool IsOf(string text, SessionOrigin origin, HarvestOptions options) =>
        text is null
            ? throw new ArgumentNullException(nameof(text))
            : text.StartsWith(SessionJson.Settings(origin, options) + SessionJson.RunsBegin, StringComparison.Ordinal);

    /// <summary>Has a text written beside the scenes when the session is opened.</summary>
    /// <param name="name">Its path within the session, with forward slashes.</param>
    /// <param name="text">The text.</param>
    public void Keep(string name, string text) => _kept.Add(new(name, text));

    /// <summary>Has a text written when the session is closed with frames, from what is known then.</summary>
    /// <param name="name">Its path within the session, with forward slashes.</param>
    /// <param name="text">Gives the text, on the writer's thread, when the harvest has ended.</param>
    public void KeepAtEnd(string name, Func<string> text) => _keptAtEnd.Add(new(name, text));

    /// <inheritdoc />
    public void Open(SessionStart start)
    {
        _start = start ?? throw new ArgumentNullException(nameof(start));
        _store = new FrameStore(
            _files,
            start.Options.Sync,
            new PictureEncoder(start.Options.Format, start.Options.JpegQuality),
            _before.KeepsManifest,
            start.Options.ViewsPerMoment,
            Replays ? _before.Events : 0
        );
        _header = new HeaderFile(_origin, _files, _store, _before, start);
        _space = new SpaceWatch(Folder, start.Options.MinFreeBytes, _disk);
        // The pictures of one moment may take more memory than all other frames in the queue.
        _queue = new BlockingCollection<CapturedFrame>(start.Options.Pairs.IsAny ? 1 : start.Options.QueueCapacity);
        _thread = new Thread(WriteAll) { IsBackground = true, Name = "harvest writer" };
        _thread.Start();
    }

    /// <inheritdoc />
    public bool TryEnqueue(CapturedFrame frame) =>
        _queue is { } queue
            ? _fault is null && Background.IsDone(nameof(TryEnqueue), () => queue.TryAdd(frame))
            : throw new InvalidOperationException("The session is not open.");

    /// <summary>
    /// Waits until the queue has room or the sink has failed. For drivers of a simulated game, whose time can stand still meanwhile.
    /// </summary>
    public void WaitForRoom()
    {
        while (_fault is null && _queue is { IsAddingCompleted: false } queue && queue.Count >= queue.BoundedCapacity)
        {
            Thread.Sleep(1);
        }
    }

    /// <inheritdoc />
    public void Close(SessionEnd end)
    {
        _end = end;
        _queue?.CompleteAdding();
    }

    /// <inheritdoc />
    public void Dispose()
    {
        _queue?.CompleteAdding();
        _thread?.Join();
        _queue?.Dispose();
        _queue = null;
        _files.Dispose();
        if (RemovesFailedStart && (_start is null || HasFailedAtStart))
        {
            EmptySession.Remove(Folder, _kept.Select(text => text.Key));
        }

        Lock?.Dispose();
    }

    /// <summary>Whether the session ended with a fault before its first frame; counted discards are worth keeping.</summary>
    private bool HasFailedAtStart => (_fault ?? _end?.Fault) is not null && FramesWritten == 0 && (_end?.Discards.Count ?? 0) == 0;

    /// <summary>The folders of frames that are there, each before the folders of views in it.</summary>
    private IEnumerable<string> InnerFolders()
    {
        foreach (string folder in FrameChannels.Folders.Select(name => Path.Combine(Folder, name)).Where(Directory.Exists))
        {
            yield return folder;
            foreach (string view in Directory.GetDirectories(folder))
            {
                yield return view;
            }
        }
    }

    private void WriteAll()
    {
        Attempt(_space!.Check);
        Attempt(() =>
        {
            _header!.Begin(_kept, FramesWritten);
            if (Replays)
            {
                _before.CutEvents(Folder);
            }
        });
        while (!_queue!.IsCompleted)
        {
            using CapturedFrame? frame = _queue.TryTake(out CapturedFrame? taken, _store!.Patience) ? taken : null;
            if (frame is not null)
            {
                Attempt(_space.Check);
            }

            Attempt(() => _store.Write(frame));
        }

        Attempt(() => _store!.Write(null));
        if (_header!.HasBegun && _end is { } end)
        {
            // After a fault too: the disk may work again, and the fault is worth recording.
            AttemptAlways(() => _header.Finish(end with { Fault = end.Fault ?? _fault }, FramesWritten, _keptAtEnd));
        }
    }

    private void Attempt(Action write)
    {
        if (_fault is null)
        {
            AttemptAlways(write);
        }
    }

    private void AttemptAlways(Action write)
    {
        if (FailureOf(write) is { } failure)
        {
            // The frames before the one that failed may still find room.
            _ = FailureOf(() => _store!.Write(null));
            _isSpaceLow |= failure is LowSpaceException;
            _fault ??=
                failure is LowSpaceException
                    ? $"{failure.Message} The session so far is valid, with {Counted.Of(FramesWritten, "frame")}. Free some "
                        + $"space and continue."
                    : $"The session in '{Folder}' cannot be written: {failure.Message.TrimEnd('.')}. "
                        + $"The session so far is valid, with {Counted.Of(FramesWritten, "frame")}. Check the disk and harvest again.";
        }
    }

    private static Exception? FailureOf(Action write)
    {
        try
        {
            write();
            return null;
        }
#pragma warning disable CA1031 // An exception on this thread would end the game; any becomes the session's fault.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            return exception;
        }
    }
}
