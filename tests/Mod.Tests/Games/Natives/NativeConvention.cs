using System.Runtime.InteropServices;
using GTA.Hosting;

namespace Harvester.Mod.Tests.Games.Natives;

/// <summary>How natives read their arguments from slots of eight bytes and write their results.</summary>
/// <param name="boolBytes">How many bytes a native writes for a BOOL: 1, 4 or 8.</param>
internal sealed class NativeConvention(int boolBytes)
{
    private const int SlotBytes = sizeof(ulong);
    private readonly Dictionary<string, IntPtr> _texts = [];

    /// <summary>
    /// The arguments as the native reads them, whatever the script meant. Those that were not passed are what the slots still hold.
    /// </summary>
    public object?[] ReadArguments(NativeSignature native, NativeCall call)
    {
        object?[] arguments = new object?[native.Parameters.Count];
        for (int i = 0; i < arguments.Length; i++)
        {
            if (i >= call.Passed.Count && (native.Parameters[i].IsText || native.Parameters[i].IsAddress))
            {
                throw new InvalidOperationException($"{native.Name} follows a stale address in slot {i}: the game would crash.");
            }

            arguments[i] = Read(native.Parameters[i], call.Arguments + (i * SlotBytes));
        }

        return arguments;
    }

    public void WriteResult(NativeSignature native, NativeCall call, object? result)
    {
        switch (result)
        {
            case null:
                break;
            case string text when native.Result.IsText:
                Marshal.WriteIntPtr(call.Result, TextOf(text));
                break;
            default:
                new NativeAddress(call.Result, native.Result, boolBytes).Write(result);
                break;
        }
    }

    /// <summary>Writes random bits as the result and to every address; a string is null or two random letters.</summary>
    public void WriteGarbage(NativeSignature native, NativeCall call, Random random)
    {
        for (int i = 0; i < native.Parameters.Count; i++)
        {
            if (native.Parameters[i].IsAddress && random.Next(2) == 0)
            {
                new NativeAddress(
                    Marshal.ReadIntPtr(call.Arguments + (i * SlotBytes)),
                    native.Parameters[i].Pointee,
                    boolBytes
                ).WriteGarbage(random);
            }
        }

        if (native.Result.IsText)
        {
            Marshal.WriteIntPtr(
                call.Result,
                random.Next(2) == 0 ? IntPtr.Zero : TextOf($"{(char)random.Next('A', 'Z')}{(char)random.Next('A', 'Z')}")
            );
        }
        else if (!native.Result.IsVoid)
        {
            new NativeAddress(call.Result, native.Result, boolBytes).WriteGarbage(random);
        }
    }

    private object? Read(NativeType type, IntPtr slot) =>
        type.IsBoolean ? Marshal.ReadInt32(slot) != 0
        : type.IsSingle ? BitConverter.Int32BitsToSingle(Marshal.ReadInt32(slot))
        : type.IsText ? Marshal.PtrToStringUTF8(Marshal.ReadIntPtr(slot))
        : type.IsAddress ? new NativeAddress(Marshal.ReadIntPtr(slot), type.Pointee, boolBytes)
        : Marshal.ReadInt32(slot);

    /// <summary>The game keeps its texts for good.</summary>
    private IntPtr TextOf(string text)
    {
        if (!_texts.TryGetValue(text, out IntPtr memory))
        {
            memory = Marshal.StringToCoTaskMemUTF8(text);
            _texts.Add(text, memory);
        }

        return memory;
    }
}
