namespace Harvester.Play.Tapes;

/// <summary>The kinds of entries, as the first byte of each.</summary>
internal enum TapeTag
{
    /// <summary>A fact about the recording.</summary>
    Fact = 1,

    /// <summary>A tick of the game.</summary>
    Tick = 2,

    /// <summary>A key was released.</summary>
    KeyUp = 3,

    /// <summary>A key was pressed.</summary>
    KeyDown = 4,

    /// <summary>A call to the game.</summary>
    Call = 5,

    /// <summary>A reading of the clock.</summary>
    Clock = 6,

    /// <summary>A picture was grabbed.</summary>
    Grab = 7,

    /// <summary>The script asked whether work on another thread was done.</summary>
    Work = 8,

    /// <summary>The end of the recording.</summary>
    End = 9,
}
