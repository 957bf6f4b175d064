using System.Globalization;

namespace Harvester.Play.Tapes;

/// <summary>An argument or a result of a call.</summary>
/// <param name="Kind">Its kind; decides which of the other values is used.</param>
/// <param name="Whole">An int, or the int in memory.</param>
/// <param name="X">A float, or the first component of a vector.</param>
/// <param name="Y">The second component of a vector.</param>
/// <param name="Z">The third component of a vector.</param>
/// <param name="Text">A text.</param>
public readonly record struct TapeValue(TapeValueKind Kind, int Whole, float X, float Y, float Z, string? Text)
{
    /// <summary>
    /// Largest difference between two floats that count as equal, relative to the larger. Sines and roots of .NET Framework and .NET differ
    /// in the last bits of a double, which can change the last bits of a float.
    /// </summary>
    private const float RelativeTolerance = 1e-5f;

    /// <summary>The same for floats near 0, metres or degrees.</summary>
    private const float AbsoluteTolerance = 1e-4f;

    /// <summary>A boolean.</summary>
    public static TapeValue Of(bool value) => new(value ? TapeValueKind.True : TapeValueKind.False, 0, 0, 0, 0, null);

    /// <summary>An int.</summary>
    public static TapeValue Of(int value) => new(TapeValueKind.Whole, value, 0, 0, 0, null);

    /// <summary>A float.</summary>
    public static TapeValue Of(float value) => new(TapeValueKind.Real, 0, value, 0, 0, null);

    /// <summary>Three floats.</summary>
    public static TapeValue Of(float x, float y, float z) => new(TapeValueKind.Vector, 0, x, y, z, null);

    /// <summary>A text.</summary>
    public static TapeValue Of(string? text) => new(text is null ? TapeValueKind.NoText : TapeValueKind.Text, 0, 0, 0, 0, text);

    /// <summary>Memory that a native writes to.</summary>
    /// <param name="before">The int that it holds before the call.</param>
    public static TapeValue Memory(int before) => new(TapeValueKind.Memory, before, 0, 0, 0, null);

    /// <summary>A failed call.</summary>
    public static TapeValue Failed(Exception exception) =>
        new(exception is InvalidOperationException ? TapeValueKind.InvalidOperation : TapeValueKind.Failure, 0, 0, 0, 0, null);

    /// <summary>Whether two arguments are the same: floats within the tolerance, everything else exactly.</summary>
    public bool IsSameAs(TapeValue other) =>
        Kind == other.Kind && Whole == other.Whole && Text == other.Text && IsNear(X, other.X) && IsNear(Y, other.Y) && IsNear(Z, other.Z);

    /// <summary>The value as text, for messages.</summary>
    public override string ToString() =>
        Kind switch
        {
            TapeValueKind.False => "false",
            TapeValueKind.True => "true",
            TapeValueKind.Whole => Whole.ToString(CultureInfo.InvariantCulture),
            TapeValueKind.Real => X.ToString("R", CultureInfo.InvariantCulture),
            TapeValueKind.Vector => FormattableString.Invariant($"<{X:R}, {Y:R}, {Z:R}>"),
            TapeValueKind.Text => $"'{Text}'",
            TapeValueKind.Memory => FormattableString.Invariant($"memory holding {Whole}"),
            _ => Kind == TapeValueKind.NoText ? "null" : Kind.ToString(),
        };

    private static bool IsNear(float a, float b) =>
        a.Equals(b) || Math.Abs(a - b) <= Math.Max(AbsoluteTolerance, RelativeTolerance * Math.Max(Math.Abs(a), Math.Abs(b)));
}
