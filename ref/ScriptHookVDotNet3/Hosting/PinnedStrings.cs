using System.Runtime.InteropServices;
using System.Text;

namespace GTA.Hosting;

/// <summary>The strings that scripts have passed to natives. They live until the end of the script's event.</summary>
internal static class PinnedStrings
{
    [ThreadStatic]
    private static List<IntPtr>? _pinned;

    public static IntPtr Pin(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text + '\0');
        IntPtr memory = Marshal.AllocHGlobal(bytes.Length);
        Marshal.Copy(bytes, 0, memory, bytes.Length);
        (_pinned ??= []).Add(memory);
        return memory;
    }

    /// <summary>Frees what this thread has pinned.</summary>
    public static void Free()
    {
        _pinned?.ForEach(Marshal.FreeHGlobal);
        _pinned?.Clear();
    }
}
