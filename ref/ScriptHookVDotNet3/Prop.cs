namespace GTA;

/// <summary>An object of the scenery.</summary>
public class Prop : Entity
{
    internal Prop(int handle)
        : base(handle) { }
}
