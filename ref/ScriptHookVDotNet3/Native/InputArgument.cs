namespace GTA.Native;

/// <summary>An argument of a native function: eight bytes.</summary>
public class InputArgument
{
    private InputArgument(ulong data, ArgumentKind kind)
    {
        Data = data;
        Kind = kind;
    }

    /// <summary>What the native gets.</summary>
    internal ulong Data { get; }

    /// <summary>What it was made from.</summary>
    internal ArgumentKind Kind { get; }

    /// <summary>Passes a bool.</summary>
    public static implicit operator InputArgument(bool value) => new(value ? 1ul : 0ul, ArgumentKind.Boolean);

    /// <summary>Passes an integer.</summary>
    public static implicit operator InputArgument(int value) => new((ulong)value, ArgumentKind.Integer);

    /// <summary>Passes a number.</summary>
    public static unsafe implicit operator InputArgument(float value)
    {
        ulong data = 0;
        *(float*)&data = value;
        return new(data, ArgumentKind.Single);
    }

    /// <summary>Passes a string.</summary>
    public static implicit operator InputArgument(string? value) => new(NativeValue.From(value), ArgumentKind.Text);

    /// <summary>Passes an address.</summary>
    public static implicit operator InputArgument(IntPtr value) => new((ulong)value.ToInt64(), ArgumentKind.Address);

    /// <summary>Passes a place for a result.</summary>
    public static implicit operator InputArgument(OutputArgument value) =>
        new((ulong)(value ?? throw new ArgumentNullException(nameof(value))).Storage.ToInt64(), ArgumentKind.Address);
}
