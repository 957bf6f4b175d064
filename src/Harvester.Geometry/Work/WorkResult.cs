namespace Harvester.Geometry.Work;

/// <summary>Receives the result of a work that has no object of its own to keep it.</summary>
/// <typeparam name="T">The result.</typeparam>
public sealed class WorkResult<T>
{
    /// <summary>The result of the last work that was given this object; the default before its end.</summary>
    public T? Value { get; set; }
}
