namespace GTA;

/// <summary>A vehicle, ped or prop.</summary>
public abstract class Entity : PoolObject
{
    private protected Entity(int handle)
        : base(handle) { }
}
