using System.Text;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Damages a file in the ways in which files are damaged, and in those in which an attacker damages them.</summary>
internal static class Mutation
{
    private static readonly byte[][] Tokens =
    [
        .. new[]
        {
            "1e300",
            "-1e300",
            "1e999",
            "-1",
            "0",
            "0.5",
            "65536",
            "2147483647",
            "2147483648",
            "-2147483648",
            "4294967296",
            "9223372036854775808",
            "NaN",
            "null",
            "true",
            "\"\"",
            "[]",
            "{}",
            "[[]]",
            "\"\\ud800\"",
            "\\udfff",
            "\\u0000",
            "\"",
            "'",
            ",",
            ":",
            "\n",
            "\r",
            "../",
            "/",
            "\\",
            "=",
            "-",
            "\uFEFF",
            "\u202E",
            "é",
            "end",
        }.Select(Encoding.UTF8.GetBytes),
        [0x00],
        [0xFF],
        [0x80],
        [0xFF, 0xFF, 0xFF, 0xF4],
        [0x7F, 0xFF, 0xFF, 0xFF],
        [0x80, 0x00, 0x00, 0x00],
        [0xED, 0xA0, 0x80],
    ];

    /// <summary>A file with one to three changes.</summary>
    public static byte[] Of(byte[] healthy, Random random)
    {
        var bytes = new List<byte>(healthy);
        for (int changes = random.Next(1, 4); changes > 0; changes--)
        {
            Change(bytes, random);
        }

        return [.. bytes];
    }

    private static void Change(List<byte> bytes, Random random)
    {
        int at = random.Next(bytes.Count + 1);
        int rest = bytes.Count - at;
        switch (random.Next(8))
        {
            case 0 when rest > 0:
                bytes[at] ^= (byte)(1 << random.Next(8));
                break;
            case 1:
                bytes.RemoveRange(at, Math.Min(random.Next(1, 40), rest));
                break;
            case 2:
                bytes.InsertRange(at, bytes.GetRange(at, Math.Min(random.Next(1, 200), rest)));
                break;
            case 3:
                bytes.RemoveRange(at, rest);
                break;
            case 4:
                bytes.InsertRange(at, Tokens[random.Next(Tokens.Length)]);
                break;
            default:
                ReplaceWord(bytes, at, Tokens[random.Next(Tokens.Length)]);
                break;
        }
    }

    /// <summary>Puts a token in the place of the number, name or run of other bytes at a place.</summary>
    private static void ReplaceWord(List<byte> bytes, int at, byte[] token)
    {
        int end = at;
        while (end < bytes.Count && end - at < 32 && IsOfWord(bytes[end]))
        {
            end++;
        }

        int start = at;
        while (start > 0 && at - start < 32 && IsOfWord(bytes[start - 1]))
        {
            start--;
        }

        bytes.RemoveRange(start, end - start);
        bytes.InsertRange(start, token);
    }

    private static bool IsOfWord(byte value) =>
        char.IsAsciiLetterOrDigit((char)value) || value is (byte)'.' or (byte)'-' or (byte)'+' or (byte)'_';
}
