namespace GTA;

/// <summary>A vehicle.</summary>
public sealed class Vehicle : Entity
{
    internal Vehicle(int handle)
        : base(handle) { }
}
