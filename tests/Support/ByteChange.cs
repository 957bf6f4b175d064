using FsCheck;
using FsCheck.Fluent;

namespace Harvester.TestSupport;

/// <summary>One change to the bytes of a file.</summary>
/// <param name="Kind">1 replaces, 2 inserts, 3 deletes, 4 repeats; 0 and less change nothing, which failures shrink towards.</param>
/// <param name="At">Where, counted modulo the file's length.</param>
/// <param name="Length">The number of bytes deleted or repeated.</param>
/// <param name="Value">The new byte.</param>
internal readonly record struct ByteChange(int Kind, int At, int Length, byte Value)
{
    /// <summary>Lists of changes, half of which change nothing.</summary>
    /// <param name="count">The length of a list.</param>
    /// <param name="maxLength">The longest run deleted or repeated, bytes.</param>
    /// <param name="values">The new bytes to choose from.</param>
    public static Arbitrary<ByteChange[]> Lists(int count, int maxLength, byte[] values) =>
        RandomCases.ArrayOf(
            Arb.Convert(
                Arb.Zip(
                    Arb.Zip(RandomCases.Integer(-3, 4), RandomCases.Integer(0, 1_000_000)),
                    Arb.Zip(RandomCases.Integer(1, maxLength), RandomCases.Integer(0, values.Length - 1))
                ),
                drawn => new ByteChange(drawn.Item1.Item1, drawn.Item1.Item2, drawn.Item2.Item1, values[drawn.Item2.Item2]),
                change => ((change.Kind, change.At), (change.Length, Math.Max(0, Array.IndexOf(values, change.Value))))
            ),
            count
        );

    /// <summary>The bytes after all changes, one after the other.</summary>
    public static byte[] Apply(IEnumerable<ByteChange> changes, byte[] healthy)
    {
        List<byte> bytes = [.. healthy];
        foreach (ByteChange change in changes)
        {
            change.ApplyTo(bytes);
        }

        return [.. bytes];
    }

    private void ApplyTo(List<byte> bytes)
    {
        if (bytes.Count == 0)
        {
            return;
        }

        int at = At % bytes.Count;
        int length = Math.Min(Length, bytes.Count - at);
        switch (Kind)
        {
            case 1:
                bytes[at] = Value;
                break;
            case 2:
                bytes.Insert(at, Value);
                break;
            case 3:
                bytes.RemoveRange(at, length);
                break;
            case 4:
                bytes.InsertRange(at, bytes.GetRange(at, length));
                break;
        }
    }
}
