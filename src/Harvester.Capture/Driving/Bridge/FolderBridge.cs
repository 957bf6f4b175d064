using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;
using System.IO;
using System.Threading;
using Harvester.Capture.Imaging;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Driving.Bridge;

/// <summary>
/// The bridge of Figure 23 of the thesis: two machines share a folder. Out go a picture a frame and state.txt with the thirteen
/// indicators; in come indicators.txt or controls.txt, and commands as command.json. Every file appears whole, by renaming. All of the
/// disk's work is done by a thread of its own.
/// </summary>
public sealed class FolderBridge : IDrivingBridge
{
    private const int PicturesKept = 10;
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(5);

    private readonly string _folder;
    private readonly FrameOutbox _outbox;
    private readonly PeerInbox _inbox = new();
    private readonly WatchedFile _indicators;
    private readonly WatchedFile _controls;
    private readonly WatchedFile _command;
    private readonly Queue<string> _pictures = new();
    private readonly PngEncoder _encoder = new();
    private readonly Thread _thread;
    private volatile bool _stopping;
    private volatile string? _problem;

    /// <summary>Opens the bridge; what a peer left in the folder earlier is not taken for new.</summary>
    /// <param name="folder">The shared folder; it is made where it is not there.</param>
    /// <param name="picture">Size of the pictures, pixels.</param>
    /// <exception cref="IOException">The folder cannot be made.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder may not be made.</exception>
    public FolderBridge(string folder, ImageSize picture)
    {
        _folder = folder ?? throw new ArgumentNullException(nameof(folder));
        Directory.CreateDirectory(folder);
        _outbox = new FrameOutbox(picture);
        _indicators = Watched("indicators.txt");
        _controls = Watched("controls.txt");
        _command = Watched("command.json");
        _thread = new Thread(Run) { IsBackground = true, Name = "Harvester folder bridge" };
        _thread.Start();
    }

    /// <inheritdoc/>
    public string? Problem => _problem;

    /// <inheritdoc/>
    public void Publish(BridgeState state, PixelBuffer picture) => _outbox.Put(state, picture);

    /// <inheritdoc/>
    public bool TryReceive([NotNullWhen(true)] out PeerMessage? message) => _inbox.TryTake(out message);

    /// <summary>Ends the bridge's thread; the last files stay in the folder.</summary>
    public void Dispose()
    {
        _stopping = true;
        _outbox.Close();
        _thread.Join();
    }

    private WatchedFile Watched(string name)
    {
        var file = new WatchedFile(Path.Combine(_folder, name));
        file.Ignore();
        return file;
    }

    private void Run()
    {
        while (!_stopping)
        {
            Try(Send);
            Try(() => Receive(_indicators, FolderMessages.ParseIndicators));
            Try(() => Receive(_controls, FolderMessages.ParseControls));
            Try(() => Receive(_command, PeerMessageParser.Parse));
        }
    }

    /// <summary>A disk that fails now may work a moment later, and a peer's bad file is followed by a good one: the bridge goes on.</summary>
    private void Try(Action action)
    {
        try
        {
            action();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or BridgeException or ArgumentException)
        {
            _problem = e.Message;
        }
    }

    private void Send()
    {
        if (!_outbox.TryTake(Poll, out BridgeState? state, out PixelBuffer picture))
        {
            return;
        }

        string name = FormattableString.Invariant($"frame_{state.Frame:00000000}.png");
        WriteWhole(name, stream => _encoder.Write(picture, stream));
        _pictures.Enqueue(name);
        byte[] text = BridgeText.StateFile(state, name);
        WriteWhole("state.txt", stream => stream.Write(text, 0, text.Length));
        while (_pictures.Count > PicturesKept)
        {
            File.Delete(Path.Combine(_folder, _pictures.Dequeue()));
        }
    }

    private void WriteWhole(string name, Action<Stream> write)
    {
        string path = Path.Combine(_folder, name);
        string temporary = path + ".part";
        using (FileStream stream = File.Create(temporary))
        {
            write(stream);
        }

        if (File.Exists(path))
        {
            File.Replace(temporary, path, null);
        }
        else
        {
            File.Move(temporary, path);
        }
    }

    private void Receive(WatchedFile file, Func<string, PeerMessage> parse)
    {
        if (file.TryReadNew(out string? text) && !_inbox.TryPut(parse(text)))
        {
            _problem = "the peer sends commands faster than the game takes them; the newest are dropped.";
        }
    }
}
