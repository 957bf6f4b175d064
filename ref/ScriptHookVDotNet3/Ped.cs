namespace GTA;

/// <summary>A person or an animal.</summary>
public sealed class Ped : Entity
{
    internal Ped(int handle)
        : base(handle) { }
}
