using System.Runtime.InteropServices;
using GTA.Native;

namespace GTA.Hosting;

/// <summary>The slots in which ScriptHookV hands arguments to the game. A call fills as many as it has arguments; the others keep what they held.</summary>
internal static class NativeStack
{
    /// <summary>Slots for arguments: what 3.6.0 passes on at most.</summary>
    public const int Slots = 32;

    private const int SlotBytes = sizeof(ulong);
    private const int ResultBytes = 24;
    private static readonly IntPtr Arguments = Allocate(Slots * SlotBytes);
    private static readonly IntPtr Result = Allocate(ResultBytes);

    /// <summary>Calls a native and returns the address of its result, which the next call overwrites.</summary>
    public static IntPtr Call(Hash native, InputArgument[] arguments, Type? expected)
    {
        ScriptThread.Require($"the native {native}");
        int count = System.Math.Min(arguments.Length, Slots);
        var passed = new ArgumentKind[count];
        for (int i = 0; i < count; i++)
        {
            Marshal.WriteInt64(Arguments, i * SlotBytes, (long)arguments[i].Data);
            passed[i] = arguments[i].Kind;
        }

        for (int offset = 0; offset < ResultBytes; offset += SlotBytes)
        {
            Marshal.WriteInt64(Result, offset, 0);
        }

        GameHost.Current.Call(new NativeCall(native, passed, Arguments, expected, Result));
        return Result;
    }

    private static IntPtr Allocate(int bytes)
    {
        IntPtr memory = Marshal.AllocHGlobal(bytes);
        Garbage.Fill(memory, bytes);
        return memory;
    }
}
