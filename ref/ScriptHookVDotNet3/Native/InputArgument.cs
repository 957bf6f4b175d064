namespace GTA.Native;

/// <summary>An argument of a native function.</summary>
public class InputArgument
{
    private InputArgument(object value) => Value = value;

    /// <summary>What the game is given: a bool, an int, a float, a string or an <see cref="OutputArgument"/>.</summary>
    internal object Value { get; }

    /// <summary>Passes a truth value.</summary>
    public static implicit operator InputArgument(bool value) => new(value);

    /// <summary>Passes a whole number.</summary>
    public static implicit operator InputArgument(int value) => new(value);

    /// <summary>Passes a number.</summary>
    public static implicit operator InputArgument(float value) => new(value);

    /// <summary>Passes a text.</summary>
    public static implicit operator InputArgument(string value) => new(value);

    /// <summary>Passes a place for a result.</summary>
    public static implicit operator InputArgument(OutputArgument value) => new(value);
}
