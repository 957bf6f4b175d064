using System;
using System.Collections.Concurrent;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using Harvester.Capture.Harvesting;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Storage;

/// <summary>
/// Writes a session to disk from a thread of its own, behind a bounded queue. A frame's picture and mask are written under temporary
/// names and renamed; then its label line is appended, and with that the frame is part of the session. When the disk fails, the
/// sink says so in <see cref="Fault"/>, and what was written stays valid.
/// </summary>
public sealed class SessionWriter : IFrameSink
{
    private readonly SessionOrigin _origin;
    private readonly ISessionFiles _files;
    private readonly SessionContent _before;
    private readonly PngEncoder _png = new();
    private PictureEncoder? _pictures;
    private BlockingCollection<CapturedFrame>? _queue;
    private Thread? _thread;
    private SessionStart? _start;
    private volatile SessionEnd? _end;
    private volatile string? _fault;
    private int _framesWritten;
    private bool _begun;

    /// <summary>Makes a writer for a new session.</summary>
    /// <param name="directory">Where to; made if it is not there, and must otherwise be empty.</param>
    /// <param name="origin">Where the session comes from.</param>
    /// <param name="resume">Whether to go on with a session that the directory holds; its frames stay, and the new ones follow
    /// them.</param>
    /// <exception cref="IOException">The directory is not empty, or cannot be made or read.</exception>
    /// <exception cref="UnauthorizedAccessException">The directory may not be written.</exception>
    public SessionWriter(string directory, SessionOrigin origin, bool resume = false)
        : this(directory, origin, resume, new SessionDirectory(directory))
    {
    }

    internal SessionWriter(string directory, SessionOrigin origin, bool resume, ISessionFiles files)
    {
        Folder = directory;
        _origin = origin ?? throw new ArgumentNullException(nameof(origin));
        _files = files;
        Directory.CreateDirectory(directory);
        if (!resume && Directory.EnumerateFileSystemEntries(directory).Any())
        {
            throw new IOException($"The directory '{directory}' is not empty. Name another, or ask to resume the session in it.");
        }

        _before = resume ? SessionContent.Read(directory) : SessionContent.Nothing;
        foreach (string folder in new[] { "", FramePaths.Frames, FramePaths.Masks, FramePaths.Scenes })
        {
            AtomicFile.DeleteLeftovers(Path.Combine(directory, folder), _ => true);
        }

        _framesWritten = _before.Frames;
    }

    /// <summary>The session's directory, as it was given.</summary>
    public string Folder { get; }

    /// <inheritdoc />
    public string? Fault => _fault;

    /// <inheritdoc />
    public int FirstFrame => _before.Frames;

    /// <inheritdoc />
    public int FirstObjectId => _before.GreatestObjectId + 1;

    /// <summary>Frames of the session that are on disk, those before a continuation included.</summary>
    public int FramesWritten => Volatile.Read(ref _framesWritten);

    /// <summary>Frames taken and not written yet.</summary>
    public int Queued => _queue?.Count ?? 0;

    /// <inheritdoc />
    public void Open(SessionStart start)
    {
        _start = start ?? throw new ArgumentNullException(nameof(start));
        _pictures = new PictureEncoder(start.Options.Format, start.Options.JpegQuality);
        _queue = new BlockingCollection<CapturedFrame>(start.Options.QueueCapacity);
        _thread = new Thread(WriteAll) { IsBackground = true, Name = "harvest writer" };
        _thread.Start();
    }

    /// <inheritdoc />
    public bool TryEnqueue(CapturedFrame frame) =>
        _queue is { } queue
            ? _fault is null && queue.TryAdd(frame)
            : throw new InvalidOperationException("The session is not open.");

    /// <summary>
    /// Waits until the queue has room or the sink has failed: for drivers of a simulated game, whose time need not go on meanwhile.
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
    }

    private void WriteAll()
    {
        Attempt(Begin);
        foreach (CapturedFrame frame in _queue!.GetConsumingEnumerable())
        {
            using (frame)
            {
                Attempt(() => Write(frame));
            }
        }

        if (_begun && _end is { } end)
        {
            // After a fault too: the disk may have come to itself, and the fault is worth noting.
            AttemptAlways(() => WriteHeader(end with { Fault = end.Fault ?? _fault }));
        }
    }

    private void Begin()
    {
        _files.MakeFolder(FramePaths.Frames);
        if (_start!.Options.Masks)
        {
            _files.MakeFolder(FramePaths.Masks);
        }

        if (_start.Options.Scenes)
        {
            _files.MakeFolder(FramePaths.Scenes);
            if (_start.Options.Faces is { } faces)
            {
                WriteText(FramePaths.Faces, FaceTableWriter.Text(faces));
            }
        }

        string header = SessionJson.Text(new SessionRecord(_origin, _start, null, _framesWritten));
        if (!_before.IsContinuedBy(header))
        {
            throw new IOException("it was recorded with other options; resume it with the same ones, or name another directory.");
        }

        WriteHeader(null);
        _begun = true;
    }

    private void Write(CapturedFrame frame)
    {
        _files.WriteWhole(frame.Label.Image, stream => _pictures!.Write(frame.Picture, stream));
        if (frame is { Label.Mask: { } path, Mask: { } mask })
        {
            _files.WriteWhole(path, stream => _png.Write(mask, stream));
        }

        if (frame.Scene is { } scene)
        {
            WriteText(FramePaths.Scene(frame.Label.Frame), SceneJson.Text(scene));
        }

        _files.AppendLabel(JsonLabelWriter.Line(frame.Label));
        Volatile.Write(ref _framesWritten, _framesWritten + 1);
    }

    private void WriteHeader(SessionEnd? end) =>
        WriteText(SessionDirectory.Header, SessionJson.Text(new SessionRecord(_origin, _start!, end, _framesWritten)));

    private void WriteText(string name, string text)
    {
        byte[] bytes = new UTF8Encoding(false).GetBytes(text);
        _files.WriteWhole(name, stream => stream.Write(bytes, 0, bytes.Length));
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
        try
        {
            write();
        }
#pragma warning disable CA1031 // An exception on this thread would end the game; whatever it is, it becomes the session's fault.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            _fault ??= FormattableString.Invariant(
                $"The session in '{Folder}' cannot be written: {exception.Message.TrimEnd('.')}. Its {_framesWritten} frames so far are complete; see to the disk and harvest again.");
        }
    }
}
