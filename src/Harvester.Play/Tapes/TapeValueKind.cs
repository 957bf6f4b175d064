namespace Harvester.Play.Tapes;

/// <summary>The kinds of values on a tape, as the first byte of each.</summary>
public enum TapeValueKind
{
    /// <summary>No value: the result of a native that is called for its effect.</summary>
    None = 0,

    /// <summary>The boolean false.</summary>
    False = 1,

    /// <summary>The boolean true.</summary>
    True = 2,

    /// <summary>An int, a handle or a hash.</summary>
    Whole = 3,

    /// <summary>A float.</summary>
    Real = 4,

    /// <summary>Three floats.</summary>
    Vector = 5,

    /// <summary>A text.</summary>
    Text = 6,

    /// <summary>A null text.</summary>
    NoText = 7,

    /// <summary>Memory that the native writes to; the value is the int that it holds before.</summary>
    Memory = 8,

    /// <summary>The call ended with an InvalidOperationException.</summary>
    InvalidOperation = 9,

    /// <summary>The call ended with another exception.</summary>
    Failure = 10,
}
