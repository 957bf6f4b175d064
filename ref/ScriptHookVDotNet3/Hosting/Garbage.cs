using System.Runtime.InteropServices;

namespace GTA.Hosting;

/// <summary>What memory holds that nobody has written: as a float 3.4e38, as an int 2139062143, as a bool true.</summary>
internal static class Garbage
{
    private const byte Each = 0x7F;

    public static void Fill(IntPtr memory, int bytes)
    {
        for (int i = 0; i < bytes; i++)
        {
            Marshal.WriteByte(memory, i, Each);
        }
    }
}
