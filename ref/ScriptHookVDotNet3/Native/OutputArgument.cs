using System;

namespace GTA.Native;

/// <summary>A place that a native function writes a result to.</summary>
public class OutputArgument : IDisposable
{
    /// <summary>Makes an empty place.</summary>
    public OutputArgument()
    {
    }

    /// <summary>Makes a place with a value that the game reads first.</summary>
    public OutputArgument(object value) => Value = value;

    /// <summary>What the game reads or has written; null as long as there is nothing.</summary>
    internal object? Value { get; set; }

    /// <summary>Gives the place back. The real one holds unmanaged memory.</summary>
    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    /// <summary>The result, as zero bytes where the game wrote nothing.</summary>
    public T GetResult<T>() => Value is null ? default! : (T)Value;

    /// <summary>Gives the place back.</summary>
    protected virtual void Dispose(bool disposing) => Value = null;
}
