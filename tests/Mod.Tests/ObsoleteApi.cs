using Mono.Cecil;

namespace Harvester.Mod.Tests;

/// <summary>
/// The stand-in as a later API might be: everything that the mod uses is obsolete, and it says that it is made for .NET Framework 4.8.
/// </summary>
internal static class ObsoleteApi
{
    private const string NewerFramework = ".NETFramework,Version=v4.8";

    /// <summary>
    /// Writes a dll in which every public type has an obsolete notice with a message (CS0618) and every member one without (CS0612).
    /// </summary>
    public static void Write(string path)
    {
        using ModuleDefinition module = ModuleDefinition.ReadModule(
            Path.Combine(
                BuiltMod.RepositoryRoot,
                "ref",
                "ScriptHookVDotNet3",
                "bin",
                BuiltMod.Configuration,
                "net472",
                "ScriptHookVDotNet3.dll"
            )
        );
        TypeReference notice = module.ImportReference(
            new TypeReference("System", nameof(ObsoleteAttribute), module, module.TypeSystem.CoreLibrary)
        );
        var bare = new MethodReference(".ctor", module.TypeSystem.Void, notice) { HasThis = true };
        var withMessage = new MethodReference(".ctor", module.TypeSystem.Void, notice) { HasThis = true };
        withMessage.Parameters.Add(new ParameterDefinition(module.TypeSystem.String));
        foreach (TypeDefinition type in module.Types.Where(type => type.IsPublic))
        {
            var message = new CustomAttribute(withMessage);
            message.ConstructorArguments.Add(new CustomAttributeArgument(module.TypeSystem.String, "Use another."));
            type.CustomAttributes.Add(message);
            IEnumerable<IMemberDefinition> members = [.. type.Methods, .. type.Properties, .. type.Events, .. type.Fields];
            foreach (IMemberDefinition member in members)
            {
                member.CustomAttributes.Add(new CustomAttribute(bare));
            }
        }

        CustomAttribute framework = module.Assembly.CustomAttributes.Single(attribute =>
            attribute.AttributeType.Name == "TargetFrameworkAttribute"
        );
        framework.ConstructorArguments[0] = new CustomAttributeArgument(module.TypeSystem.String, NewerFramework);
        module.Assembly.Name.Version = new Version(3, 7, 0, 112);
        module.Write(path);
    }
}
