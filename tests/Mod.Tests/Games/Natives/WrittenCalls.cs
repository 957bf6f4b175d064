using GTA.Math;
using GTA.Native;
using Mono.Cecil;
using Mono.Cecil.Cil;

namespace Harvester.Mod.Tests.Games.Natives;

/// <summary>
/// Reads all calls of natives out of the built mod. Each is a hash, an array of converted arguments and the call, in this order.
/// </summary>
internal static class WrittenCalls
{
    private const string CallsOfNatives = "Harvester.Mod.Natives";
    private const string CallsOfApi = "GTA.Native.Function";
    private const string Conversion = "op_Implicit";
    private const string Argument = "Harvester.Mod.NativeArgument";
    private const string Api = "Harvester.Mod.ScriptApi";
    private const string HashType = "GTA.Native.Hash";

    private static readonly Dictionary<string, ArgumentKind> Kinds = new()
    {
        ["System.Boolean"] = ArgumentKind.Boolean,
        ["System.Int32"] = ArgumentKind.Integer,
        ["System.Single"] = ArgumentKind.Single,
        ["System.String"] = ArgumentKind.Text,
        ["System.IntPtr"] = ArgumentKind.Address,
        ["Harvester.Mod.NativeOutput"] = ArgumentKind.Address,
    };

    private static readonly Dictionary<string, Type> Results = new()
    {
        ["System.Boolean"] = typeof(bool),
        ["System.Int32"] = typeof(int),
        ["System.Single"] = typeof(float),
        ["System.String"] = typeof(string),
        ["GTA.Math.Vector3"] = typeof(Vector3),
    };

    /// <summary>
    /// All calls; the mod makes them through the two methods of <c>Natives</c> that hand them on to the API, by way of <c>ScriptApi</c>.
    /// </summary>
    public static IReadOnlyList<WrittenCall> Read(string path)
    {
        using ModuleDefinition module = ModuleDefinition.ReadModule(path);
        MethodDefinition[] methods =
        [
            .. module
                .GetTypes()
                .SelectMany(type => type.Methods)
                .Where(method => method.HasBody && !IsCall(method) && method.DeclaringType.FullName != Api && method.Name != Conversion),
        ];
        Assert.DoesNotContain(
            methods.SelectMany(method => method.Body.Instructions),
            instruction => instruction.Operand is MethodReference { DeclaringType.FullName: CallsOfApi }
        );
        return [.. methods.SelectMany(method => In(method, methods))];
    }

    private static IEnumerable<WrittenCall> In(MethodDefinition method, MethodDefinition[] all)
    {
        // Calls may stand among the arguments of others.
        var open = new Stack<(Instruction Hash, List<ArgumentKind> Passed)>();
        foreach (Instruction instruction in method.Body.Instructions)
        {
            switch (instruction.Operand)
            {
                case TypeReference { FullName: Argument } when instruction.OpCode == OpCodes.Newarr:
                    open.Push((instruction.Previous.Previous, []));
                    break;
                case GenericInstanceMethod { Name: "Empty" } empty when empty.GenericArguments[0].FullName == Argument:
                    open.Push((instruction.Previous, []));
                    break;
                case MethodReference { Name: Conversion, ReturnType.FullName: Argument } conversion:
                    open.Peek().Passed.Add(Kinds[conversion.Parameters[0].ParameterType.FullName]);
                    break;
                case MethodReference called when IsCall(called):
                    (Instruction hash, List<ArgumentKind> passed) = open.Pop();
                    Type? expected = called is GenericInstanceMethod generic ? Results[generic.GenericArguments[0].FullName] : null;
                    foreach (Hash native in HashesOf(hash, method, all))
                    {
                        yield return new WrittenCall(method.FullName, native, passed, expected);
                    }

                    break;
                default:
                    break;
            }
        }

        Assert.Empty(open);
    }

    /// <summary>The native of a call: what is loaded, or all that callers pass for the parameter that is loaded.</summary>
    private static IEnumerable<Hash> HashesOf(Instruction load, MethodDefinition method, MethodDefinition[] all)
    {
        if (load.Operand is long constant)
        {
            return [(Hash)constant];
        }

        ParameterDefinition last = method.Parameters[^1];
        Assert.Equal(HashType, last.ParameterType.FullName);
        Assert.Equal(method.Parameters.Count - 1, LoadedArgument(load) - (method.HasThis ? 1 : 0));
        return all.SelectMany(caller => caller.Body.Instructions)
            .Where(instruction => instruction.Operand is MethodReference called && called.FullName == method.FullName)
            .Select(instruction => (Hash)(long)instruction.Previous.Operand);
    }

    private static int LoadedArgument(Instruction load) =>
        load.OpCode.Code switch
        {
            Code.Ldarg_0 => 0,
            Code.Ldarg_1 => 1,
            Code.Ldarg_2 => 2,
            Code.Ldarg_3 => 3,
            _ => throw new InvalidDataException($"The native of a call is neither constant nor a parameter: {load}"),
        };

    private static bool IsCall(MethodReference method) => method.Name == "Call" && method.DeclaringType.FullName == CallsOfNatives;
}
