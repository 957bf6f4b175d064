namespace Harvester.Sessions.Imaging.Pictures;

/// <summary>The checksum of a PNG chunk: ISO 3309, polynomial 0xEDB88320 reflected, with eight tables for eight bytes per step.</summary>
public static class Crc32
{
    private const int Slices = 8;
    private static readonly uint[][] Tables = MakeTables();

    /// <summary>The checksum of bytes that follow others.</summary>
    /// <param name="previous">Checksum of the bytes before; 0 at the start.</param>
    /// <param name="bytes">The array of the bytes.</param>
    /// <param name="count">Number of bytes, from the first.</param>
    public static uint Append(uint previous, byte[] bytes, int count)
    {
        uint crc = ~previous;
        int i = 0;
        for (; i + Slices <= count; i += Slices)
        {
            // Slicing by eight (Kounavis and Berry 2005): the table of slice k has the remainder of a byte with k bytes of zeros after it;
            // remainders add by exclusive or.
            uint low = crc ^ (uint)(bytes[i] | (bytes[i + 1] << 8) | (bytes[i + 2] << 16) | (bytes[i + 3] << 24));
            crc =
                Tables[7][low & 0xFF]
                ^ Tables[6][(low >> 8) & 0xFF]
                ^ Tables[5][(low >> 16) & 0xFF]
                ^ Tables[4][low >> 24]
                ^ Tables[3][bytes[i + 4]]
                ^ Tables[2][bytes[i + 5]]
                ^ Tables[1][bytes[i + 6]]
                ^ Tables[0][bytes[i + 7]];
        }

        for (; i < count; i++)
        {
            crc = Tables[0][(crc ^ bytes[i]) & 0xFF] ^ (crc >> 8);
        }

        return ~crc;
    }

    private static uint[][] MakeTables()
    {
        const uint polynomial = 0xEDB88320;
        var tables = new uint[Slices][];
        for (int slice = 0; slice < Slices; slice++)
        {
            tables[slice] = new uint[256];
            for (uint value = 0; value < 256; value++)
            {
                uint crc = slice == 0 ? value : tables[slice - 1][value];
                if (slice == 0)
                {
                    for (int bit = 0; bit < 8; bit++)
                    {
                        crc = (crc & 1) != 0 ? polynomial ^ (crc >> 1) : crc >> 1;
                    }
                }
                else
                {
                    crc = tables[0][crc & 0xFF] ^ (crc >> 8);
                }

                tables[slice][value] = crc;
            }
        }

        return tables;
    }
}
