using System.Runtime.ExceptionServices;
using Harvester.Play.Tapes;

namespace Harvester.Tapes;

/// <summary>
/// The place on a tape that is being played. Calls and grabs must come in the order of the tape. Readings of the clock and states of work
/// on other threads are no questions to the game: those that the mod does not ask for are skipped, and others repeat the last one.
/// </summary>
internal sealed class TapeCursor : IDisposable
{
    /// <summary>Most characters of all facts together.</summary>
    private const int MaxFactCharacters = 16 << 20;

    /// <summary>
    /// Last reading of the clock, which begins with the recording: a day of 100 ns steps. A recording takes 10 minutes and the event that
    /// is under way then.
    /// </summary>
    private const long MaxClockSteps = 864_000_000_000;

    private readonly IEnumerator<TapeEntry> _entries;
    private readonly CancellationToken _cancellation;
    private readonly Dictionary<string, bool> _work = new(StringComparer.Ordinal);
    private double _milliseconds;

    /// <summary>Begins at the first entry.</summary>
    /// <param name="entries">The entries of the tape.</param>
    /// <param name="cancellation">Ends the answers.</param>
    public TapeCursor(IEnumerable<TapeEntry> entries, CancellationToken cancellation)
    {
        _entries = entries.GetEnumerator();
        _cancellation = cancellation;
        Advance();
    }

    /// <summary>The entry that comes next; null after the last.</summary>
    public TapeEntry? Next { get; private set; }

    /// <summary>The first difference; nothing is compared after it.</summary>
    public TapeDifference? Difference { get; private set; }

    /// <summary>Why the tape cannot be read on; null if it can.</summary>
    public ExceptionDispatchInfo? Fault { get; private set; }

    /// <summary>Ticks begun.</summary>
    public int Tick { get; private set; }

    /// <summary>Calls and grabs that were the same.</summary>
    public long Calls { get; private set; }

    /// <summary>Whether there are no answers any more.</summary>
    public bool IsStopped => IsCancelled || Difference is not null || Next is null or TapeEnd;

    /// <summary>Whether the user ended the playback.</summary>
    public bool IsCancelled => _cancellation.IsCancellationRequested;

    /// <summary>Takes the facts at the start.</summary>
    /// <exception cref="InvalidDataException">They are longer than any recording has.</exception>
    public Dictionary<string, string> TakeFacts()
    {
        var facts = new Dictionary<string, string>(StringComparer.Ordinal);
        long characters = 0;
        for (; !IsCancelled && Next is TapeFact fact; Advance())
        {
            characters += fact.Name.Length + fact.Text.Length;
            if (characters > MaxFactCharacters)
            {
                throw new InvalidDataException("its facts exceed the limit of 16 Mi characters.");
            }

            facts[fact.Name] = fact.Text;
        }

        return facts;
    }

    /// <summary>Takes the next event, a tick or a key; null if none follows.</summary>
    public TapeEntry? TakeEvent()
    {
        SkipReadings();
        if (IsStopped)
        {
            return null;
        }

        TapeEntry entry = Next!;
        if (entry is not (TapeTick or TapeKey))
        {
            Differ(Describe(entry), "no further call in this event");
            return null;
        }

        Tick += entry is TapeTick ? 1 : 0;
        Advance();
        return entry;
    }

    /// <summary>Takes a call or a grab that must be the next.</summary>
    /// <param name="isSame">Whether an entry is the one that the mod asks for.</param>
    /// <param name="got">Describes what the mod asks for.</param>
    /// <exception cref="TapeStoppedException">It is not the next, or the tape has ended.</exception>
    public T Take<T>(Func<T, bool> isSame, Func<string> got)
        where T : TapeEntry
    {
        SkipReadings();
        if (IsStopped)
        {
            throw new TapeStoppedException();
        }

        if (Next is not T entry || !isSame(entry))
        {
            throw Differ(Describe(Next!), got());
        }

        Calls++;
        Advance();
        return entry;
    }

    /// <summary>The time, milliseconds.</summary>
    public double TakeClock()
    {
        if (Next is TapeClock clock)
        {
            _milliseconds = clock.Milliseconds;
            Advance();
        }

        return _milliseconds;
    }

    /// <summary>The recorded state of work on another thread; null if the tape never had it.</summary>
    public bool? TakeWork(string what)
    {
        if (Next is TapeWork work && work.What == what)
        {
            _work[what] = work.IsDone;
            Advance();
        }

        return _work.TryGetValue(what, out bool last) ? last : null;
    }

    /// <summary>Records a difference, unless there is one.</summary>
    public TapeStoppedException Differ(string expected, string got)
    {
        Difference ??= new TapeDifference(Tick, Calls + 1, expected, got);
        return new TapeStoppedException();
    }

    public void Dispose() => _entries.Dispose();

    private static string Describe(TapeEntry entry) =>
        entry switch
        {
            TapeCall call => PlayedApi.Describe(call.Target, call.Asked),
            TapeGrab grab => PlayedScreen.Describe(grab.Width, grab.Height),
            _ => "no further call in this event",
        };

    private void SkipReadings()
    {
        for (; !IsCancelled && Next is TapeClock or TapeWork; Advance())
        {
            switch (Next)
            {
                case TapeClock clock:
                    _milliseconds = clock.Milliseconds;
                    break;
                case TapeWork work:
                    _work[work.What] = work.IsDone;
                    break;
            }
        }
    }

    private void Advance()
    {
        // The mod catches what its calls throw, so a damaged tape ends here and is reported afterwards.
        try
        {
            Next = _entries.MoveNext() ? _entries.Current : null;
            if (Next is TapeClock { Steps: < 0 or > MaxClockSteps })
            {
                throw new InvalidDataException("it is damaged: a reading of the clock is out of range.");
            }
        }
        catch (Exception exception) when (exception is IOException or InvalidDataException)
        {
            (Next, Fault) = (null, ExceptionDispatchInfo.Capture(exception));
        }
    }
}
