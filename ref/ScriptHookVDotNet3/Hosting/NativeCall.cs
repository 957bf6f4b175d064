using GTA.Native;

namespace GTA.Hosting;

/// <summary>A call of a native as the game gets it.</summary>
/// <param name="native">The native.</param>
/// <param name="passed">What the script passed, by position. The slots after these hold what earlier calls left there.</param>
/// <param name="arguments">Address of the slots, eight bytes each.</param>
/// <param name="expected">The type that the script reads the result as; null when it ignores the result.</param>
/// <param name="result">Address of 24 zeroed bytes for the result.</param>
internal sealed class NativeCall(Hash native, IReadOnlyList<ArgumentKind> passed, IntPtr arguments, Type? expected, IntPtr result)
{
    public Hash Native { get; } = native;

    public IReadOnlyList<ArgumentKind> Passed { get; } = passed;

    public IntPtr Arguments { get; } = arguments;

    public Type? Expected { get; } = expected;

    public IntPtr Result { get; } = result;
}
