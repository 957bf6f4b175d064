using System;
using System.Diagnostics.CodeAnalysis;
using System.IO;
using System.Threading;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Driving.Bridge;

/// <summary>
/// The bridge of Figure 23 of the thesis: two machines share a folder. Out go a picture a frame and state.txt with the thirteen
/// indicators; in come indicators.txt or controls.txt, and commands as command.json. Every file appears whole, by renaming. All of the
/// disk's work is done by a thread of its own. A folder does not tell who writes or that nobody does any more: a client counts as gone when
/// nothing has been written for long, and another begins with a hello.
/// </summary>
public sealed class FolderBridge : IDrivingBridge
{
    /// <summary>
    /// How long a client may give no sign of life, seconds, when nothing else is said: enough for a learner to think between two steps.
    /// </summary>
    public const double DefaultPatienceSeconds = 30;

    private const double MillisecondsPerSecond = 1000;
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(5);

    /// <summary>Another machine's folder may keep the thread waiting for minutes.</summary>
    private static readonly TimeSpan MaxWaitForThread = TimeSpan.FromSeconds(5);

    private readonly string _folder;
    private readonly double _patienceSeconds;
    private readonly IClock _clock;
    private readonly FrameOutbox _outbox;
    private readonly FrameFiles _frames;
    private readonly ClientInbox<FolderBridge> _inbox = new();
    private readonly WatchedFile _indicators;
    private readonly WatchedFile _controls;
    private readonly WatchedFile _command;
    private readonly WatchedFile _alive;
    private readonly Thread _thread;
    private double _heardMilliseconds;
    private volatile bool _stopping;
    private volatile string? _problem;

    /// <summary>Opens the bridge; what a client left in the folder earlier is not taken for new.</summary>
    /// <param name="folder">The shared folder; it is made where it is not there.</param>
    /// <param name="picture">Size of the pictures, pixels.</param>
    /// <param name="patienceSeconds">After how long without a sign of life the client counts as gone, seconds of the player's time.</param>
    /// <exception cref="IOException">The folder cannot be made.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder may not be made.</exception>
    public FolderBridge(string folder, ImageSize picture, double patienceSeconds = DefaultPatienceSeconds)
        : this(folder, picture, patienceSeconds, new PlayerClock())
    {
    }

    internal FolderBridge(string folder, ImageSize picture, double patienceSeconds, IClock clock)
    {
        _folder = folder ?? throw new ArgumentNullException(nameof(folder));
        _patienceSeconds = patienceSeconds;
        _clock = clock;
        Directory.CreateDirectory(folder);
        _outbox = new FrameOutbox(picture);
        _frames = new FrameFiles(folder);
        _indicators = Watched("indicators.txt");
        _controls = Watched("controls.txt");
        _command = Watched("command.json");
        _alive = Watched("alive.txt");
        _thread = new Thread(Run) { IsBackground = true, Name = "Harvester folder bridge" };
        _thread.Start();
    }

    /// <inheritdoc/>
    public string? Problem => _problem;

    /// <inheritdoc/>
    public string? Client => _inbox.Client is null ? null : _folder;

    /// <inheritdoc/>
    public void Publish(BridgeState state, PixelBuffer picture) => _outbox.Put(state, picture);

    /// <inheritdoc/>
    public bool TryReceive([NotNullWhen(true)] out ClientMessage? message) => _inbox.TryTake(out message);

    /// <summary>Ends the bridge's thread; the last files stay in the folder.</summary>
    public void Dispose()
    {
        _stopping = true;
        _outbox.Close();
        _thread.Join(MaxWaitForThread);
    }

    private WatchedFile Watched(string name)
    {
        var file = new WatchedFile(Path.Combine(_folder, name));
        file.TrySee();
        return file;
    }

    private void Run()
    {
        using FrameFiles frames = _frames;
        Try(frames.DeleteEarlier);
        while (!_stopping)
        {
            Try(Send);
            Try(() => Receive(_command, TakeCommand));
            Try(() => Receive(_indicators, text => Put(FolderMessages.ParseIndicators(text))));
            Try(() => Receive(_controls, text => Put(FolderMessages.ParseControls(text))));
            Try(Listen);
        }
    }

    /// <summary>
    /// A disk that fails now may work a moment later, and a client's bad file is followed by a good one: the bridge goes on.
    /// </summary>
    private void Try(Action action)
    {
        try
        {
            action();
        }
#pragma warning disable CA1031 // An exception that leaves a thread ends the game, whatever its type.
        catch (Exception e) when (e is not ThreadAbortException)
#pragma warning restore CA1031
        {
            _problem = e.Message;
        }
    }

    private void Send()
    {
        if (_outbox.TryTake(Poll, static _ => true, out BridgeState? state, out PixelBuffer picture))
        {
            _frames.Put(state, picture);
        }

        _frames.Write();
    }

    private void Receive(WatchedFile file, Action<string> take)
    {
        if (file.TryReadNew(out string? text))
        {
            Hear();
            take(text);
        }
    }

    private void TakeCommand(string text)
    {
        if (JsonFields.Parse(text).Text("type") == "hello")
        {
            _inbox.Leave(this);
            _inbox.Welcome(this);
        }
        else
        {
            Put(ClientMessageParser.Parse(text));
        }
    }

    private void Put(ClientMessage message)
    {
        if (!_inbox.TryPut(this, message))
        {
            _problem = "the client sends commands faster than the game processes them; the newest are dropped.";
        }
    }

    private void Listen()
    {
        if (_alive.TrySee())
        {
            Hear();
        }
        else if (_clock.Milliseconds - _heardMilliseconds > _patienceSeconds * MillisecondsPerSecond && _inbox.Leave(this))
        {
            _problem = FormattableString.Invariant($"no message from the client for {_patienceSeconds} s; it counts as disconnected.");
        }
    }

    private void Hear()
    {
        _heardMilliseconds = _clock.Milliseconds;
        _inbox.Welcome(this);
    }
}
