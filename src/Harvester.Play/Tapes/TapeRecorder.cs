using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Tapes;

/// <summary>
/// Records what passes between the mod and the game on a tape. Entries are encoded into memory; another thread compresses and writes
/// them, so that the game's thread never waits for the disk. The recording ends by itself at its limits, with a message. All calls come
/// from the script's thread.
/// </summary>
public sealed class TapeRecorder : IDisposable
{
    /// <summary>Size at which the encoded entries are handed to the other thread, bytes.</summary>
    private const int ChunkBytes = 256 * 1024;

    /// <summary>Largest size of all chunks that wait for the disk, bytes.</summary>
    private const long MaxWaitingBytes = 64L << 20;

    private const double MillisecondsPerMinute = 60_000;
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(2);

    private readonly TapeOptions _options;
    private readonly IClock _clock;
    private readonly Action<string> _tell;
    private readonly TapeEncoder _encoder = new();
    private readonly TapeFile _file;
    private readonly DiskQueue _disk = new();
    private readonly string _name;
    private readonly double _startMilliseconds;
    private long _waiting;
    private long _written;
    private long _unpacked;
    private volatile bool _isOn = true;
    private bool _isInEvent;

    /// <summary>Starts a recording; the file is created on another thread.</summary>
    /// <param name="options">What to record.</param>
    /// <param name="clock">Real time.</param>
    /// <param name="tell">Tells the player when the recording ends.</param>
    public TapeRecorder(TapeOptions options, IClock clock, Action<string> tell)
    {
        _options = options ?? throw new ArgumentNullException(nameof(options));
        _clock = clock ?? throw new ArgumentNullException(nameof(clock));
        _tell = tell ?? throw new ArgumentNullException(nameof(tell));
        _name = DateTime.Now.ToString("'tape-'yyyyMMdd-HHmmss", CultureInfo.InvariantCulture) + TapeFormat.Extension;
        _file = new TapeFile(Path.Combine(options.Folder, _name));
        _startMilliseconds = clock.Milliseconds;
    }

    /// <summary>Whether the recording goes on.</summary>
    public bool IsOn => _isOn;

    /// <summary>Whether something is still being written.</summary>
    public bool IsBusy => _disk.IsBusy;

    /// <summary>Records a fact.</summary>
    public void Fact(string name, string text)
    {
        if (_isOn)
        {
            _encoder.Add(new TapeFact(name, text));
        }
    }

    /// <summary>Records that an event of the script begins; it ends with <see cref="EndEvent"/>.</summary>
    /// <param name="key">The key; null for a tick.</param>
    public void BeginEvent(TapeKey? key)
    {
        if (!_isOn)
        {
            return;
        }

        _isInEvent = true;
        _encoder.Add(key is null ? new TapeTick() : key);
    }

    /// <summary>The end of an event: limits are checked between events, so that a tape has whole ones.</summary>
    public void EndEvent()
    {
        _isInEvent = false;
        if (!_isOn)
        {
            return;
        }

        if (_disk.TakeFailure() is { } failure)
        {
            Stop($"The tape cannot be written: {failure.Message}");
        }
        else if (_clock.Milliseconds - _startMilliseconds >= _options.Minutes * MillisecondsPerMinute)
        {
            Stop(FormattableString.Invariant($"The recording ended after {_options.Minutes} minutes: {_name} in the sessions folder."));
        }
        else if (Interlocked.Read(ref _written) >= _options.MaxFileBytes || _unpacked >= _options.MaxUnpackedBytes)
        {
            Stop($"The recording ended because the tape is full: {_name} in the sessions folder.");
        }
        else if (Interlocked.Read(ref _waiting) > MaxWaitingBytes)
        {
            Stop($"The recording ended because the disk is too slow: {_name} in the sessions folder.");
        }
    }

    /// <summary>Records a call.</summary>
    public void Call(TapeCall call)
    {
        if (_isOn)
        {
            _encoder.Add(call);
            FlushIfFull();
        }
    }

    /// <summary>Records a reading of the clock; returns what the tape says it was.</summary>
    public double Clock(double milliseconds)
    {
        if (!_isOn)
        {
            return milliseconds;
        }

        var clock = new TapeClock((long)Math.Round(milliseconds * TapeClock.StepsPerMillisecond));
        _encoder.Add(clock);
        return clock.Milliseconds;
    }

    /// <summary>Records a picture.</summary>
    public void Grab(PixelBuffer picture, GrabResult result)
    {
        if (_isOn && picture is not null)
        {
            bool isKept = result.IsGood && _options.Choice == TapeChoice.NativesAndPictures;
            _encoder.Add(
                new TapeGrab(
                    picture.Size.Width,
                    picture.Size.Height,
                    result.Refusal,
                    result.IsGood ? PictureFingerprint.Of(picture.Bytes) : 0,
                    isKept ? picture.Bytes : null
                )
            );
            FlushIfFull();
        }
    }

    /// <summary>Records the state of work on another thread.</summary>
    public void Work(string what, bool isDone)
    {
        if (_isOn)
        {
            _encoder.Add(new TapeWork(what, isDone));
        }
    }

    /// <summary>The message for the player when the recording begins.</summary>
    public string Greeting =>
        FormattableString.Invariant(
            $"A tape is being recorded for {_options.Minutes} minutes, in the sessions folder. The setting Record under [Tape] ends that."
        );

    /// <summary>
    /// Ends the recording with the script. May come on another thread while the script's own is stopped within an event; what that thread
    /// has begun to encode is then left out.
    /// </summary>
    public void Finish()
    {
        if (_isOn && !_isInEvent)
        {
            Close("the script ended");
        }

        _isOn = false;
        _disk.Add(_file.Dispose);
    }

    /// <summary>Ends the recording and waits until it is written, or for as long as a script may take to end.</summary>
    public void Dispose()
    {
        Finish();
        _disk.Wait(MaxWaitForDisk);
    }

    private void Stop(string message)
    {
        Close(message.Substring(0, message.IndexOf(':')));
        _disk.Add(_file.Dispose);
        _tell(message);
    }

    private void Close(string reason)
    {
        _isOn = false;
        _encoder.Add(new TapeEnd(reason));
        Flush();
    }

    private void FlushIfFull()
    {
        if (_encoder.Length >= ChunkBytes)
        {
            Flush();
        }
    }

    private void Flush()
    {
        byte[] chunk = _encoder.Take();
        _unpacked += chunk.Length;
        Interlocked.Add(ref _waiting, chunk.Length);
        _disk.Add(() =>
        {
            try
            {
                Interlocked.Add(ref _written, _file.Append(chunk));
            }
            finally
            {
                Interlocked.Add(ref _waiting, -chunk.Length);
            }
        });
    }
}
