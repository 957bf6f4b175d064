using GTA.Native;
using Harvester.Play.Tapes;

namespace Harvester.Mod;

/// <summary>An argument of a native. The API's own cannot be read, so a tape could not record it.</summary>
internal readonly struct NativeArgument
{
    private readonly TapeValue _value;
    private readonly NativeOutput? _output;

    private NativeArgument(TapeValue value, NativeOutput? output = null)
    {
        _value = value;
        _output = output;
    }

    /// <summary>The argument as a tape has it; of memory what it holds now.</summary>
    public TapeValue Recorded => _output is { } output ? TapeValue.Memory(output.Integer) : _value;

    /// <summary>The memory; null if the argument is a value.</summary>
    public NativeOutput? Output => _output;

    public static implicit operator NativeArgument(bool value) => new(TapeValue.Of(value));

    public static implicit operator NativeArgument(int value) => new(TapeValue.Of(value));

    public static implicit operator NativeArgument(float value) => new(TapeValue.Of(value));

    public static implicit operator NativeArgument(string? value) => new(TapeValue.Of(value));

    public static implicit operator NativeArgument(NativeOutput output) => new(default, output);

    /// <summary>The arguments as the API takes them.</summary>
    public static InputArgument[] ForApi(NativeArgument[] arguments) => Array.ConvertAll(arguments, argument => argument.ForApi());

    private InputArgument ForApi() =>
        _output is { } output
            ? output.Address
            : _value.Kind switch
            {
                TapeValueKind.False => false,
                TapeValueKind.True => true,
                TapeValueKind.Whole => _value.Whole,
                TapeValueKind.Real => _value.X,
                _ => _value.Text,
            };
}
