using System.Text;

namespace Harvester.Exports.Formats.WebDataset;

/// <summary>
/// Looks at the headers of a tar archive before it is read. The runtime holds long names and extended headers in memory, whatever their
/// length. Fields: POSIX.1-2017, pax, "ustar Interchange Format".
/// </summary>
internal static class TarNames
{
    private const int BlockLength = 512;
    private const int LengthAt = 124;
    private const int LengthDigits = 12;
    private const int TypeAt = 156;
    private const int MaxNameBytes = 1 << 20;

    /// <summary>What is wrong with the names in an archive; null for nothing. The archive is at its start afterwards.</summary>
    public static string? Problem(FileStream archive)
    {
        byte[] header = new byte[BlockLength];
        try
        {
            while (archive.ReadAtLeast(header, BlockLength, throwOnEndOfStream: false) == BlockLength && header[0] != 0)
            {
                long length = LengthOf(header);
                if (header[TypeAt] is (byte)'x' or (byte)'g' or (byte)'L' or (byte)'K' && length is < 0 or > MaxNameBytes)
                {
                    return $"the name or the extended header of an entry has more than {MaxNameBytes} bytes, the limit.";
                }

                long next = archive.Position + ((Math.Max(length, 0) + BlockLength - 1) / BlockLength * BlockLength);
                if (length < 0 || next > archive.Length)
                {
                    // Damage, which the reader reports.
                    break;
                }

                archive.Seek(next, SeekOrigin.Begin);
            }

            return null;
        }
        finally
        {
            archive.Seek(0, SeekOrigin.Begin);
        }
    }

    /// <summary>The length of an entry in octal digits, or in base 256 after a byte of 0x80; -1 if it is neither.</summary>
    private static long LengthOf(byte[] header)
    {
        if (header[LengthAt] == 0x80)
        {
            long value = 0;
            for (int i = LengthAt + LengthDigits - sizeof(long); i < LengthAt + LengthDigits; i++)
            {
                value = unchecked((value << 8) | header[i]);
            }

            return Math.Max(value, -1);
        }

        string digits = Encoding.ASCII.GetString(header, LengthAt, LengthDigits).Trim('\0', ' ');
        long octal = 0;
        foreach (char digit in digits)
        {
            if (digit is < '0' or > '7')
            {
                return -1;
            }

            octal = (octal * 8) + (digit - '0');
        }

        return octal;
    }
}
