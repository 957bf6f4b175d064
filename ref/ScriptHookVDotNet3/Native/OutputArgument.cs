using System.Runtime.InteropServices;
using GTA.Hosting;

namespace GTA.Native;

/// <summary>A place that a native function writes a result to: 24 bytes of memory that nobody clears.</summary>
public class OutputArgument : IDisposable
{
    private const int Bytes = 24;
    private IntPtr _storage;

    /// <summary>Makes a place that holds whatever was in memory.</summary>
    public OutputArgument()
    {
        _storage = Marshal.AllocCoTaskMem(Bytes);
        Garbage.Fill(_storage, Bytes);
    }

    /// <summary>Makes a place whose first eight bytes are a value.</summary>
    /// <exception cref="InvalidCastException">The value is neither null nor a string nor an <see cref="INativeValue"/>.</exception>
    public OutputArgument(object? value)
        : this() => Marshal.WriteInt64(_storage, (long)NativeValue.From(value));

    /// <summary>Frees the memory.</summary>
    ~OutputArgument() => Dispose(false);

    internal IntPtr Storage => _storage != IntPtr.Zero ? _storage : throw new ObjectDisposedException(nameof(OutputArgument));

    /// <summary>Frees the memory.</summary>
    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    /// <summary>What the memory holds now, written or not.</summary>
    public unsafe T GetResult<T>() => NativeValue.To<T>((ulong*)Storage);

    /// <summary>Frees the memory.</summary>
    protected virtual void Dispose(bool disposing)
    {
        Marshal.FreeCoTaskMem(_storage);
        _storage = IntPtr.Zero;
    }
}
